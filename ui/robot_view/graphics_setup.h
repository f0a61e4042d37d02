#pragma once

namespace heft {

/// Asks Qt for the OpenGL surfaces that the 3D view needs. Call before QApplication is made.
void prepareGraphics();

}  // namespace heft
