"""Backend: a scene as a picture, through its PDF."""

from __future__ import annotations

from io import BytesIO

from ..scene import Scene
from .pdf import to_pdf


def to_png(scene: Scene, dpi: float = 150.0) -> bytes:
    """The scene as PNG; 25.4 mm are `dpi` pixels."""
    import pypdfium2

    document = pypdfium2.PdfDocument(to_pdf(scene))
    try:
        image = document[0].render(scale=dpi / 72).to_pil()
    finally:
        document.close()
    target = BytesIO()
    image.save(target, format="PNG", dpi=(dpi, dpi))
    return target.getvalue()
