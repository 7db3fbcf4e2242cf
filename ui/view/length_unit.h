/// Lengths as they are shown; scenes and files keep metres.
#pragma once

namespace hanei {

enum class LengthUnit { metre, centimetre, millimetre, feet_inches };

}  // namespace hanei
