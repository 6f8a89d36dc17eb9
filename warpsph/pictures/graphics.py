"""Whether VTK can draw here: without graphics libraries it does not raise an error, it dies."""

import ctypes
import functools
import os
import subprocess
import sys

MESSAGE = (
    "no graphics libraries that work here, so pictures are drawn in a simpler way; "
    "for shaded ones install EGL or OSMesa (Debian, Ubuntu: apt-get install libegl1 libgl1-mesa-dri)"
)
CHOICE = "VTK_DEFAULT_OPENGL_WINDOW"  # the environment variable that VTK obeys
WINDOWS = {
    "vtkEGLRenderWindow": ("libEGL.so.1",),
    "vtkOSMesaRenderWindow": ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"),
    "vtkXOpenGLRenderWindow": ("libGL.so.1",),
}

DRAW_NOTHING = (
    "import vtkmodules.vtkRenderingOpenGL2, vtkmodules.vtkRenderingCore as core;"
    "window = core.vtkRenderWindow(); window.SetOffScreenRendering(1); window.SetSize(8, 8); window.Render()"
)


@functools.cache
def graphics_available() -> bool:
    """Look for the libraries, then let a child process draw, which may die in our place; before VTK is imported."""
    if not sys.platform.startswith("linux") or CHOICE in os.environ:
        return _child_draws(dict(os.environ))
    for window, libraries in WINDOWS.items():
        if any(map(_loads, libraries)) and _child_draws(os.environ | {CHOICE: window}):
            os.environ[CHOICE] = window
            return True
    return False


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def _child_draws(environment: dict[str, str]) -> bool:
    command = [sys.executable, "-c", DRAW_NOTHING]
    try:
        return subprocess.run(command, capture_output=True, env=environment, timeout=60).returncode == 0
    except (OSError, subprocess.SubprocessError):
        return False
