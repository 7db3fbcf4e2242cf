/// Scripts that use the desk as a person does.
///
///     click WIDGET                  a widget by its name (print widgets lists them)
///     click object NAME             an object where it is seen in the view
///     double WIDGET | double object NAME    a double click
///     right WIDGET | right object NAME      a click with the right button
///     click ... with Shift | Ctrl | Alt     with a key held; right clicks too
///     box X Y X Y [with Shift | Ctrl]       a box over the view, from corner to corner, after key B
///     hold WIDGET | hold object NAME        presses the left button there ...
///     move DX DY                            ... moves the pointer by pixels ...
///     release                               ... and lets go
///     point WIDGET | point object NAME | point X Y
///     drag WIDGET by DX DY          pixels
///     drag object NAME by DX DY DZ  metres: in the plan, or up with the z arrow
///     drag object NAME by DX DY DZ in SECONDS    by the clock, 60 frames a second if they can be had
///     drop FILE... X Y | drop FILE... object NAME
///     wheel NOTCHES
///     key CHORD                     Ctrl+Z, Delete, F1
///     key CHORD for SECONDS         held down, in made-up time
///     type TEXT
///     wait converged | wait exact | wait FRAMES
///     shot FILE.png                 the whole window
///     record FOLDER every N         a picture of every Nth frame from here to the report
///     report latency                how long frames and answers took since `record`; writes its pictures
///     print state | print widgets | print NAME
///     expect NAME VALUE [within TOLERANCE]
///     remember NAME                 then: expect-changed NAME, expect-same NAME
///
/// Words with spaces stand in double quotes; # begins a remark.
#pragma once

#include "engine/base/diagnostic.h"
#include "ui/window/driver.h"

#include <iosfwd>
#include <map>
#include <string_view>

namespace hanei {

/// Plays the script until its end or its first fault, which it returns with its line.
/// `out` takes what is printed. Files are relative to the working folder.
std::optional<Diagnostic> play_script(std::string_view text, const std::string& file, Driver& driver,
                                      std::ostream& out);

}  // namespace hanei
