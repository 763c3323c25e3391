"""A description of every key of a problem file, in both languages, by the model and the key."""

from __future__ import annotations

from ...figures import scales
from ...words import Words
from .load_words import LOADS
from .marking_words import MARKING

KEYS = {
    "Problem.id": Words("题号：字母（汉字）、数字、- _ .", "id: letters, digits, - _ ."),
    "Problem.title": Words("题目名称：一个文本，或 {zh: ..., en: ...}", "title: one text, or {zh: ..., en: ...}"),
    "Problem.extends": Words(
        "沿用其数据的题号或文件；只写不同之处，null 去掉一个键",
        "id or file of a problem whose data are taken over; only what differs is written, null takes a key away",
    ),
    "Problem.source": Words("出处", "where the problem is printed"),
    "Problem.statement": Words("题目正文；符号写在 $ 之间", "the text of the problem; symbols between dollar signs"),
    "Problem.explain": Words(
        "用文字回答的各问，作业题目上留有横线：[{zh: 机构类型, en: type of linkage}]",
        "what is answered in words; a question sheet has lines for it: [{zh: ..., en: type of linkage}]",
    ),
    "Problem.frame": Words("机架上的固定点：A: [0 mm, 0 mm]", "the fixed points: A: [0 mm, 0 mm]"),
    "Problem.links": Words("按编号列出活动构件；机架不写", "the moving links by number; the frame has no entry"),
    "Problem.joints": Words(
        "移动副和滚动副，每个一句话；转动副不写", "sliding and rolling joints, a sentence each; pins need no entry"
    ),
    "Problem.input": Words(
        "原动件：转动（phi、omega、alpha）或移动（s、v、a）",
        "the input: turning (phi, omega, alpha) or sliding (s, v, a)",
    ),
    "Problem.branch": Words("装配方式：C above AD；C 在 AD 上方", "which assembly: C above AD"),
    "Problem.scales": Words("比例尺：给定，或 auto", "scales: given, or auto"),
    "Problem.find": Words("所求的量：v_E、a_E、omega_2", "what is asked: v_E, a_E, omega_2"),
    "Problem.method": Words(
        "速度分析用多边形（polygons）或瞬心（centres）；轨迹的曲率（curvature）",
        "velocities by vector polygons, or by instant centres; curvatures of paths",
    ),
    "Problem.construction": Words(
        "method: curvature 时所用的作图法", "with method: curvature, the construction by which they are found"
    ),
    "Problem.printed": Words("待核对的书中答案", "printed answers to be checked"),
    "Problem.errata": Words("已知的印刷错误", "known misprints"),
    "Problem.tables": Words(
        "待核对的数据表（CSV、XLSX），写本文件旁的路径",
        "printed tables (CSV, XLSX) to be checked, as paths beside this file",
    ),
    "Problem.sheet": Words("图纸", "the drawing sheet"),
    "Problem.guesses": Words("点的大致位置，用于Ⅲ级杆组", "rough positions of points, for groups of class III"),
    "Problem.pins": Words(
        "复合铰链的销轴固定在哪个构件上：{C: 3}", "which link carries the pin of a multiple joint: {C: 3}"
    ),
    "Problem.loads": Words(
        "作用于机构的力和力矩；其中一个待求", "forces and moments on the mechanism; one of them is unknown"
    ),
    "Problem.friction": Words("转动副、移动副和接触点的摩擦", "friction of pins, slides and contacts"),
    "Problem.masses": Words("构件的质量、转动惯量和质心", "masses of links, their inertia and centres"),
    "Problem.weight": Words(
        "是否计重力（yes/no，默认 no）", "does gravity act on the masses (no, where nothing is said)"
    ),
    "Problem.inertia": Words("是否计惯性力（yes/no，默认 yes）", "do inertia forces act (yes, where nothing is said)"),
    "Problem.vary": Words(
        "各学生的题目中不同的量及其范围：{AB: 80 mm .. 120 mm by 5 mm}",
        "what differs from student to student: {AB: 80 mm .. 120 mm by 5 mm}",
    ),
    "Problem.target": Words("给定曲线，与一点的轨迹一同画出", "a curve beside which the path of a point is drawn"),
    "TargetSpec.point": Words("画出其轨迹的点", "the point whose path is drawn"),
    "TargetSpec.through": Words("给定曲线上的点", "points of the curve"),
    "TargetSpec.closed": Words("曲线是否封闭（yes/no，默认 no）", "does the curve close (no, where nothing is said)"),
    "Problem.gate": Words("对每个学生的题目作图的要求", "what the drawing of every variant must be like"),
    "GateSpec.vectors": Words("所评矢量的最小图上长度：15 mm", "how long a graded vector is on paper at least: 15 mm"),
    "GateSpec.meetings": Words(
        "两线、两弧或线与弧的最小交角：20 deg", "the least angle at which lines and arcs meet: 20 deg"
    ),
    "GateSpec.dead_point": Words("离死点的最小角度：10 deg", "how far from a dead point at least: 10 deg"),
    "GateSpec.deviation": Words(
        "所评各量的 2σ 与其大小之比的上限：15 %", "2σ of a graded quantity over its size, at most: 15 %"
    ),
    "GateSpec.slips": Words(
        "出错者的读数至少与正确值相差几倍允差 T：1",
        "how many tolerances T the readings of a slip differ from the right ones: 1",
    ),
    "GateSpec.apart": Words(
        "任两名学生至少有两个读数相差几倍允差 T：3", "how many tolerances T two readings of any two students differ: 3"
    ),
    "GateSpec.alike": Words(
        "转向与作图动作是否须与原题相同（yes/no，默认 yes）",
        "must senses and acts be those of the problem itself (yes, where nothing is said)",
    ),
    "Problem.device": Words(
        "机械装置的种类：不是连杆机构而是斜面、螺旋等",
        "a device instead of a mechanism: a wedge, a screw, a train of machines",
    ),
    "Problem.synthesis": Words(
        "综合题型：机构待求，如 crank-rocker", "a mechanism that is to be found, by its task: crank-rocker"
    ),
    "Problem.data": Words("机械装置或综合题的已知数据", "the data of the device, or of the synthesis"),
    "Problem.salt": Words("换一个文本，全班的数据就都不同", "another text gives everybody other numbers"),
    **MARKING,
    "Problem.title_block": Words("作业的标题栏：课程、班级、姓名", "title block of an assignment: course, class, name"),
    "Problem.problems": Words(
        "作业中的题目：题号、文件，或 {problem: 3-9, ...}",
        "the problems of an assignment: ids, files, or {problem: 3-9, ...}",
    ),
    "Item.problem": Words("题号或文件", "id or file of the problem"),
    "InputSpec.link": Words("原动件的编号", "number of the driving link"),
    "InputSpec.phi": Words("位置角：60 deg，或 60 deg from AD", "position: 60 deg, or 60 deg from AD"),
    "InputSpec.omega": Words(
        "角速度：10 rad/s ccw、40 r/min 顺时针；只需转向时写 ccw",
        "angular velocity: 10 rad/s ccw, 40 r/min cw; ccw alone where only the sense matters",
    ),
    "InputSpec.alpha": Words("角加速度：5 rad/s^2 ccw", "angular acceleration: 5 rad/s^2 ccw"),
    "InputSpec.s": Words("沿导路由原点量起的位移：120 mm", "travel along the guide from its origin: 120 mm"),
    "InputSpec.v": Words("移动速度：0.5 m/s", "velocity along the guide: 0.5 m/s"),
    "InputSpec.a": Words("移动加速度：2 m/s^2", "acceleration along the guide: 2 m/s^2"),
    "InputSpec.on": Words(
        "相对于哪个活动构件运动；不写时相对于机架",
        "the moving link on which the link moves; the frame where nothing is said",
    ),
    "InputSpec.cylinder": Words("被驱动的移动副的两构件：2-3", "the two links of the driven sliding pair: 2-3"),
    "InputSpec.length": Words("液压缸两铰链间的长度：900 mm", "length of a cylinder between its two pins: 900 mm"),
    **LOADS,
    "FrictionSpec.rho": Words("摩擦圆半径：6 mm", "radius of a pin's friction circle: 6 mm"),
    "FrictionSpec.f": Words("摩擦系数：0.1", "coefficient of friction: 0.1"),
    "FrictionSpec.f_v": Words("当量摩擦系数，代替 f", "equivalent coefficient, in the place of f"),
    "FrictionSpec.r": Words("轴颈半径：20 mm；ρ = f r", "radius of the pin: 20 mm; rho = f r"),
    "FrictionSpec.phi": Words("摩擦角：8 deg", "friction angle: 8 deg"),
    "FrictionSpec.V": Words("槽形半角：f_v = f / sin V", "half the angle of a V-groove: f_v = f / sin V"),
    "RodSpec.diameter": Words("圆杆直径：50 mm", "diameter of a round bar: 50 mm"),
    "RodSpec.density": Words("密度：7800 kg/m^3", "density: 7800 kg/m^3"),
    "RodSpec.along": Words(
        "杆两端的点，默认为构件的前两点", "two points of the link, its first two where nothing is said"
    ),
    "MassSpec.mass": Words("质量：3 kg", "mass: 3 kg"),
    "MassSpec.inertia": Words(
        "绕质心的转动惯量：0.02 kg*m^2", "moment of inertia about the centre of mass: 0.02 kg*m^2"
    ),
    "MassSpec.centre": Words("质心：构件上的点，或位置", "centre of mass: a point of the link, or a place"),
    "MassSpec.rod": Words("圆杆：质量与转动惯量由尺寸算出", "a round bar: mass and inertia follow from its section"),
    **{
        f"ScalesSpec.{key}": Words(f"{mu.called.zh}：{mu.example}", f"{mu.called.en.partition(' ')[2]}: {mu.example}")
        for key, mu in scales().items()
    },
    "FindSpec.point": Words("所求的点，字母后为构件号：M2", "a point to be found, its letter and its link: M2"),
    "FindSpec.on": Words("点所在的构件", "the link of the point"),
    "FindSpec.velocity": Words(
        "该点的速度：[-0.25 m/s, 0.14 m/s] 或 0", "velocity of the point: [-0.25 m/s, 0.14 m/s], or 0"
    ),
    "FindSpec.acceleration": Words(
        "该点的加速度：[1 m/s^2, 0 m/s^2] 或 0", "acceleration of the point: [1 m/s^2, 0 m/s^2], or 0"
    ),
    "FindSpec.coriolis": Words(
        "判断哥氏加速度有无与方向：B3B2", "does the Coriolis term exist, and where does it point: B3B2"
    ),
    "FindSpec.slowest": Words("此直线上速度最小的点：BC", "the slowest point of the link on this line: BC"),
    "FindSpec.centrodes": Words("作此构件的两条瞬心线", "the link whose two centrodes are drawn"),
    "FindSpec.positions": Words("作瞬心线所取的位置数：10", "through how many positions the centrodes are drawn: 10"),
    "FindSpec.over": Words(
        "作瞬心线时原动件的首末位置：[20 deg, 110 deg]",
        "first and last position of the input for the centrodes: [20 deg, 110 deg]",
    ),
    "PrintedSpec.symbol": Words("量的符号：v_E、l_BC", "symbol of the quantity: v_E, l_BC"),
    "PrintedSpec.value": Words(
        "书中的值：0.177 m/s，或图上长度 41.1 mm", "the printed value: 0.177 m/s, or a length on paper: 41.1 mm"
    ),
    "PrintedSpec.scale": Words("值为图上长度时的比例尺", "where the value is a length on paper: its scale"),
    "PrintedSpec.direction": Words("书中的方向：180 deg", "the printed direction: 180 deg"),
    "PrintedSpec.kind": Words("计算（calculated）或图解（graphical）", "calculated, or read off a drawing (graphical)"),
    "PrintedSpec.lost": Words(
        "该答案属于已失的原题数据（本题数据为另定）；只与其余原书答案相互校核",
        "it belongs to data that are lost, in whose place are our own: held only against the other printed answers",
    ),
    "PrintedSpec.figures": Words(
        "书中演算所取的有效数字位数，结果只按此校核",
        "to how many figures the book reckoned on the way; it is held to no more",
    ),
    "PrintedSpec.note": Words("附注", "a note"),
    "SheetSpec.orientation": Words("竖放（portrait）或横放（landscape）", "portrait or landscape"),
    "SheetSpec.format": Words("图纸幅面：A4 或 letter", "the format of the paper: A4 or letter"),
    "Link.block": Words("滑块，写其铰链字母", "a block, by its one pin"),
    "Link.slot": Words("导杆（槽），写槽所过的铰链", "a slotted link: the pin through which the slot passes"),
    "Link.rod": Words("穿过滑块的直杆，写其铰链", "a straight rod that passes through a block, by its pin"),
    "Link.cylinder": Words("液压缸的缸体，写其铰链", "the barrel of a hydraulic cylinder, by its pin"),
    "Link.piston": Words("液压缸的活塞与活塞杆，写其铰链", "the piston with its rod, by its pin"),
    "Link.gear": Words("齿轮，写其中心", "a gear, by its centre"),
    "Link.rack": Words("齿条，写其节线所过的铰链", "a rack, by the pin through which its pitch line passes"),
    "Link.phi": Words(
        "齿轮（或由齿轮带动的杆）在给定位置的方向角：40 deg",
        "how a gear, or an arm that gears drive, stands in the given position: 40 deg",
    ),
    "Link.s": Words(
        "由齿轮带动的齿条在给定位置的位移：40 mm", "travel of a rack that a gear drives, in the given position: 40 mm"
    ),
    "Link.disc": Words("圆盘、偏心轮或圆头，写其中心", "a disc, eccentric or round tip, by its centre"),
    "Link.cam": Words(
        "盘形凸轮，写其凸轮题和转动中心：profile of cam-heart about O",
        "a plate cam, by its problem and its pivot: profile of cam-heart about O",
    ),
    "Link.face": Words("平面（平底），写其所过的铰链", "a flat face, by the pin through which it passes"),
    "Link.radius": Words("齿轮节圆或圆盘的半径：60 mm", "radius of the pitch circle or of the disc: 60 mm"),
    "Link.alpha": Words(
        "齿轮或齿条的压力角，缺省为 20 deg", "pressure angle of a gear's or a rack's teeth, 20 deg where left out"
    ),
    "Link.length": Words("两个字母及其长度：BC: 350 mm", "two letters and a length: BC: 350 mm"),
    "Link.point": Words("构件上另一点的位置", "the place of a further point"),
    "Place.along": Words("由此两点的连线量起：BC", "set out along this line: BC"),
    "Place.at": Words("沿线的距离：60 mm", "distance along the line: 60 mm"),
    "Place.left": Words("向左偏离：40 mm", "offset to the left: 40 mm"),
    "Place.right": Words("向右偏离：40 mm", "offset to the right: 40 mm"),
    "Place.angle": Words("由射线量起的角：50 deg from BC", "angle from a ray: 50 deg from BC"),
    "Place.side": Words("在线的哪一侧：left of BC", "on which side: left of BC"),
    "Place.length": Words("到另一点的长度：BE: 200 mm", "length to another point: BE: 200 mm"),
    "Slot.through": Words("槽或平面所过（或旁离）的铰链", "the pin through which, or beside which, it passes"),
    "Slot.angle": Words("与射线的夹角：60 deg from CD", "angle from a ray: 60 deg from CD"),
    "Slot.left": Words("向左偏离铰链：31 mm", "offset to the left of the pin: 31 mm"),
    "Slot.right": Words("向右偏离铰链：31 mm", "offset to the right of the pin: 31 mm"),
    "Text.zh": Words("中文", "in Chinese"),
    "Text.en": Words("英文", "in English"),
}
