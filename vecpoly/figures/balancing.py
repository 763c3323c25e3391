"""质径积多边形、力偶多边形、振动矢量图、矢端曲线: the figures of balancing, and the end view of a rotor."""

from __future__ import annotations

from ..words import Words
from .hue import Hue
from .kind import View, register
from .mu import Mu

INK, TINT = Hue("products", (0.33, 0.05, 0.38)), Hue("products_tint", (0.95, 0.90, 0.96), is_tint=True)
SHAKING = Hue("vibration", (0.45, 0.20, 0.02))

END_VIEW = register(
    View(
        name="end-view",
        order=61,
        title=Words("端视图", "End view"),
        called=Words("端视图", "the end view"),
        mu=Mu(
            symbol="μ_r",
            unit="m",
            called=Words("半径比例尺", "a scale of radii"),
            listed=Words("端视图的长度比例尺", "scale of lengths of the end view"),
            example="0.005 m/mm",
        ),
        bodies=True,
    )
)
COUPLES = register(
    View(
        name="couples",
        order=62,
        title=Words("力偶多边形", "Couple polygon"),
        called=Words("力偶多边形", "the couple polygon"),
        mu=Mu(
            symbol="μ_{Wl}",
            unit="kg·m^2",
            called=Words("力偶比例尺", "a scale of couples"),
            listed=Words("力偶（质径矩积）比例尺", "scale of couples W l"),
            example="0.02 kg*m^2/mm",
        ),
        ink=INK,
        tint=TINT,
    )
)
PRODUCTS = register(
    View(
        name="products",
        order=63,
        title=Words("质径积多边形", "Mass–radius polygon"),
        called=Words("质径积多边形", "the mass–radius polygon"),
        mu=Mu(
            symbol="μ_W",
            unit="kg·m",
            called=Words("质径积比例尺", "a scale of mass–radius products"),
            listed=Words("质径积比例尺", "scale of mass–radius products"),
            example="0.02 kg*m/mm",
        ),
        ink=INK,
        tint=TINT,
    )
)
UNBALANCES = register(
    View(
        name="unbalances",
        order=64,
        title=Words("不平衡量多边形", "Unbalance polygon"),
        called=Words("不平衡量多边形", "the unbalance polygon"),
        mu=Mu(
            symbol="μ_W",
            typed="mu_U",
            unit="g·mm",
            called=Words("不平衡量比例尺", "a scale of unbalances"),
            listed=Words("不平衡量比例尺", "scale of unbalances"),
            example="10 g*mm/mm",
        ),
        ink=INK,
        tint=TINT,
    )
)
VIBRATION = register(
    View(
        name="vibration",
        order=65,
        title=Words("振动矢量图", "Vibration vectors"),
        called=Words("振动矢量图", "the diagram of vibrations"),
        mu=Mu(
            symbol="μ_A",
            unit="μm",
            called=Words("振幅比例尺", "a scale of amplitudes"),
            listed=Words("振幅比例尺", "scale of amplitudes"),
            example="0.1 um/mm",
        ),
        ink=SHAKING,
    )
)
VIBRATION_SPEED = register(
    View(
        name="vibration-speed",
        order=66,
        title=Words("振动矢量图", "Vibration vectors"),
        called=Words("振动矢量图", "the diagram of vibrations"),
        mu=Mu(
            symbol="μ_V",
            unit="mm/s",
            called=Words("振动速度比例尺", "a scale of vibration velocities"),
            listed=Words("振动速度比例尺", "scale of vibration velocities"),
            example="0.1 (mm/s)/mm",
        ),
        ink=SHAKING,
    )
)
HODOGRAPH = register(
    View(
        name="hodograph",
        order=67,
        title=Words("惯性力矢端曲线", "Hodograph of the shaking force"),
        called=Words("惯性力矢端曲线", "the hodograph of the shaking force"),
        mu=Mu(
            symbol="μ_P",
            unit="N",
            called=Words("惯性力比例尺", "a scale of inertia forces"),
            listed=Words("惯性力比例尺", "scale of inertia forces"),
            example="40 N/mm",
        ),
        ink=INK,
        tint=TINT,
    )
)
