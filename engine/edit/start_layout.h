/// The field of luminaires that the lumen method asks for, hung in the room.
#pragma once

#include "engine/edit/edit.h"
#include "engine/edit/lumen_method.h"

namespace hanei {

/// What the lumen method's working plane is called among the calculation grids.
inline constexpr const char* working_plane_name = "Working plane";

/// A field of luminaires like this one, as the answer says, mounted as the wish says; and a
/// calculation grid over the working plane within its border, unless one of that name and height is
/// there. The arrangement the luminaire hung in takes the new layout.
///
/// Needs     an answer without refusal, to this wish for this luminaire.
/// Returns   the arrangement as the object that was added.
Added with_start_layout(Scene scene, ObjectId luminaire, const LumenWish& wish, const LumenAnswer& answer);

/// The calculation grid of the working plane; the id of nothing when there is none.
ObjectId working_plane_of(const Scene& scene);

/// All luminaires of the arrangement dimmed by one factor, to full output at most.
Scene with_output_scaled(Scene scene, ObjectId arrangement, double factor);

}  // namespace hanei
