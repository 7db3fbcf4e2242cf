/// Changes to luminaires and what they are measured to shine: a scene in, a scene out.
#pragma once

#include "engine/scene/scene.h"

#include <string>

namespace hanei {

/// A scene the window would rather have, and the step's name in the history.
struct SceneEdit {
    Scene scene;
    std::string step;
};

/// Null when there is no such luminaire.
const Luminaire* find_luminaire(const Scene& scene, ObjectId id);

/// What the luminaire is measured to shine; null when it is not.
const Photometry* photometry_of(const Scene& scene, const Luminaire& luminaire);

/// How many luminaires shine as this photometry says.
int users_of(const Scene& scene, ObjectId photometry);

/// The id of an equal photometry of the scene; else that of this one, which joins the scene.
ObjectId photometry_in(Scene& scene, Photometry photometry);

/// The luminaire shines as `photometry` says, and with it all that share its present one when `all`
/// is set. A photometry the scene holds already is used again, one that nobody uses any longer is dropped.
Scene with_photometry(Scene scene, ObjectId luminaire, Photometry photometry, bool all);

/// The same from another file: outputs that were set for the old file are as measured again, and
/// luminaires that were not measured take the file's opening. A colour temperature that the file
/// states is taken over; else the luminaire keeps its own.
Scene with_other_file(Scene scene, ObjectId luminaire, Photometry photometry, bool all);

/// The intensities turned by a quarter against the opening, counter-clockwise seen from above.
Photometry turned_by_a_quarter(Photometry photometry);

/// An angle (rad) a quarter turn on, within half a turn of 0.
double turned_by_a_quarter(double angle);

/// The object itself turned by a quarter about the vertical, counter-clockwise seen from above: a
/// luminaire or a piece of furniture; the scene as it is for anything else.
Scene turned_by_a_quarter(Scene scene, ObjectId object);

}  // namespace hanei
