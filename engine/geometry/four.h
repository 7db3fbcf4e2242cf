/// Four single precision numbers at a time: what the compiler's vector types offer on every machine,
/// one rounding an operation as everywhere.
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace hanei {

using Four = float __attribute__((vector_size(16)));
using FourFlags = int __attribute__((vector_size(16)));  ///< all bits set: true

inline Four all_four(float value) { return Four{value, value, value, value}; }

/// Bit k is set where flag k is.
inline int bits_of(FourFlags flags) {
#if defined(__SSE__)
    return _mm_movemask_ps(reinterpret_cast<__m128>(flags));
#else
    return (flags[0] & 1) | (flags[1] & 2) | (flags[2] & 4) | (flags[3] & 8);
#endif
}

}  // namespace hanei
