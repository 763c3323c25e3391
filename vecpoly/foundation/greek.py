"""The Greek letters of quantities as their keys spell them: omega_3 is ω_3."""

from __future__ import annotations

GREEK = {
    "omega": "ω", "alpha": "α", "eta": "η", "phi": "φ", "rho": "ρ", "delta": "δ", "lambda": "λ", "gamma": "γ",
    "theta": "θ", "psi": "ψ", "beta": "β", "dW": "ΔW",
}  # fmt: skip
