"""A description of every datum of every device, in both languages."""

from __future__ import annotations

from ...words import Words
from .balancing_words import BALANCING
from .moving_words import MOVING

_F, _Q = Words("摩擦系数", "coefficient of friction"), Words("载荷", "the load")
_EFFICIENCY = (
    ("belt", "带传动", "a belt"),
    ("chain", "链传动", "a chain"),
    ("gear", "齿轮副", "a pair of gears"),
    ("worm", "蜗杆传动", "a worm drive"),
    ("bearing", "轴承", "a bearing"),
    ("coupling", "联轴器", "a coupling"),
    ("screw", "螺旋", "a screw"),
    ("conveyor", "输送机", "a conveyor"),
    ("winch", "卷筒", "a winch"),
    ("pump", "泵", "a pump"),
    ("machine", "工作机", "a machine"),
)

_CAM = {
    "cam.follower": Words("从动件", "the follower"),
    "cam.motion": Words("一周内的运动，依次列出", "its motion over a turn, piece by piece"),
    "cam.r0": Words("基圆半径（理论廓线的）", "radius of the base circle, of the pitch curve"),
    "cam.alpha": Words("许用压力角，代替 r0", "allowed pressure angles, in place of r0"),
    "cam.turns": Words("凸轮的转向", "sense in which the cam turns"),
    "cam.stations": Words("分点间隔", "angle between the stations"),
    "Follower.knife": Words("尖顶从动件（yes）", "a knife edge (yes)"),
    "Follower.roller": Words("滚子半径", "radius of the roller"),
    "Follower.flat": Words("平底从动件（yes）", "a flat face (yes)"),
    "Follower.offset": Words("偏距，导路在轴心右侧为正", "offset of the guide, to the right of the axis positive"),
    "Follower.arm": Words("摆杆", "the arm on which it swings"),
    "Arm.OA": Words("轴心到摆动中心的距离", "distance of the arm's pivot from the axis"),
    "Arm.AB": Words("摆杆长度；平底没有", "length of the arm; a flat face has none"),
    "Arm.side": Words("摆动中心在轴心的哪一侧：left 或 right", "on which side of the axis its pivot is: left or right"),
    "Arm.face": Words(
        "平底到摆动中心的距离，背离凸轮为正", "distance of a flat face from the pivot, positive away from the cam"
    ),
    "Allowed.rise": Words("推程许用压力角", "allowed on the rise"),
    "Allowed.return": Words("回程许用压力角", "allowed on the return"),
    "Allowed.start": Words(
        "推程起始处另一侧的许用压力角（过起始点的第三条界线）",
        "allowed to the other side where the rise begins: a third bound through that point",
    ),
}

_GEARS = {
    "epicyclic.sun": Words("太阳轮 1 的齿数", "teeth of sun 1"),
    "epicyclic.planet": Words("行星轮的齿数；双联时写两个", "teeth of the planets; of stepped ones two numbers"),
    "epicyclic.ring": Words("内齿轮 3 的齿数", "teeth of ring 3"),
    "epicyclic.sun_2": Words("第二个太阳轮 3 的齿数", "teeth of gear 3 where it is a second sun"),
    "epicyclic.m": Words("第一对齿轮的模数", "module of the first pair"),
    "epicyclic.omega_1": Words("太阳轮 1 的角速度", "angular velocity of sun 1"),
    "epicyclic.omega_3": Words("中心轮 3 的角速度", "angular velocity of gear 3"),
    "epicyclic.omega_H": Words("系杆 H 的角速度", "angular velocity of carrier H"),
    "gear-generation.m": Words("模数", "module"),
    "gear-generation.z": Words("齿数", "number of teeth"),
    "gear-generation.x": Words("变位系数", "shift of the rack, in modules"),
    "gear-generation.steps": Words("齿条位置数", "how many places of the rack are drawn"),
    "gear-generation.alpha": Words("齿形角", "angle of the rack's flanks"),
    "gear-generation.ha": Words("齿顶高系数", "addendum of the rack, in modules"),
    "gear-generation.c": Words("顶隙系数", "clearance, in modules"),
}

DATA = {
    **BALANCING,
    **MOVING,
    **_CAM,
    **_GEARS,
    "eccentric-clamp.e": Words("偏心距", "eccentricity of the disc"),
    "eccentric-clamp.theta": Words("轮心相对于 A 的方向角", "direction of the disc's centre from A"),
    "eccentric-clamp.R": Words("偏心轮半径", "radius of the disc"),
    "eccentric-clamp.l": Words("手柄长度", "length of the handle"),
    "eccentric-clamp.handle": Words("手柄的方向角", "direction of the handle"),
    "eccentric-clamp.F": Words("手柄力的方向角", "direction of the force on the handle"),
    "eccentric-clamp.closing": Words("夹紧的转向", "sense in which the clamp closes"),
    "eccentric-clamp.f": _F,
    "eccentric-clamp.rho": Words("A 处摩擦圆半径", "radius of the friction circle at A"),
    "eccentric-clamp.Q": Words("夹紧力", "the clamping force"),
    "incline.f": _F,
    "incline.beta": Words("力与水平方向的夹角", "angle of the force above the horizontal"),
    "incline.Q": Words("滑块重量", "weight of the block"),
    "incline.alpha": Words("斜面倾角；求自锁极限时略去", "slope of the plane; left out: the limit of self-locking"),
    "power-train.train": Words("传动系统的各级，依次列出", "the parts of the train, in order"),
    **{f"Part.{key}": Words(f"{zh}的效率", f"efficiency of {en}") for key, zh, en in _EFFICIENCY},
    "Part.parallel": Words("分流的各支路", "the branches into which the train parts"),
    "Part.name": Words("末端的字母", "letter of an end"),
    "Part.P": Words("输出功率", "power delivered"),
    "Part.F": Words("输出端的力", "force overcome at the end"),
    "Part.v": Words("输出端的速度", "speed at which it is overcome"),
    "ring-spring.alpha": Words(
        "各接触面的法线与 F 作用线的夹角", "angle of the normals of all faces from the line of F"
    ),
    "ring-spring.f": _F,
    "ring-spring.Q": Words("每侧楔块所受的力", "force on each side wedge"),
    "screw-jack.d": Words("螺纹大径", "outer diameter of the thread"),
    "screw-jack.d1": Words("螺纹小径", "root diameter of the thread"),
    "screw-jack.p": Words("螺距", "pitch"),
    "screw-jack.starts": Words("线数", "number of threads"),
    "screw-jack.D": Words("支承环面外径", "outer diameter of the collar"),
    "screw-jack.d0": Words("支承环面内径", "inner diameter of the collar"),
    "screw-jack.l": Words("手柄长度", "length of the lever"),
    "screw-jack.f": Words("螺纹和支承面的摩擦系数", "coefficient of friction of thread and collar"),
    "screw-jack.f_thread": Words("螺纹的摩擦系数", "coefficient of friction of the thread"),
    "screw-jack.f_collar": Words("支承面的摩擦系数", "coefficient of friction of the collar"),
    "screw-jack.beta": Words(
        "三角形螺纹的牙侧角；矩形螺纹略去", "half the flank angle of a V-thread; left out for a square one"
    ),
    "screw-jack.Q": _Q,
    "screw-jack.F": Words("手柄力", "force on the lever"),
    "structure.joints": Words(
        "各运动副：R、P、H、G 及其构件和位置", "the joints: R, P, H, G with their links and places"
    ),
    "structure.drivers": Words(
        "原动件，列出各种取法；1+3 为两个原动件", "the drivers, each possibility; 1+3: two that drive together"
    ),
    "structure.frame": Words("机架的编号", "number of the frame"),
    "structure.links": Words("全部构件，供与运动副核对", "all links, to be checked against the joints"),
    "vee-guide.f": _F,
    "vee-guide.G": Words("重力", "the weight"),
    "vee-guide.l1": Words("G 到 V 形导轨的距离", "distance of G from the V guide"),
    "vee-guide.l2": Words("G 到平导轨的距离", "distance of G from the flat guide"),
    "vee-guide.theta": Words("V 形槽的半角", "half the angle of the V"),
    "wedge-clamp.alpha": Words("楔角", "angle of the wedge"),
    "wedge-clamp.f": Words("两接触面的摩擦系数", "coefficient of friction of both faces"),
    "wedge-clamp.R": Words("夹紧力 R_23", "the clamping force R_23"),
    "wedges.alpha": Words("楔块 1 的导路与竖直方向的夹角", "guide of wedge 1 from the vertical"),
    "wedges.beta": Words("两楔块接触面与竖直方向的夹角", "face between the wedges from the vertical"),
    "wedges.Q": Words("楔块 2 上的载荷", "load on wedge 2"),
    "wedges.f": Words("各接触面相同的摩擦系数", "one coefficient of friction for all faces"),
    **{
        f"wedges.f{i}{j}": Words(f"构件 {i} 与 {j} 间的摩擦系数", f"coefficient of friction between {i} and {j}")
        for i, j in ("12", "13", "23")
    },
}
