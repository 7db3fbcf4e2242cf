/// Lines and words that tools draw over a picture.
#pragma once

#include "ui/panels/pane.h"

#include <string>
#include <vector>

namespace hanei::sketch {

/// Through places of the room, with a dark halo so that it is seen on any ground.
void line(const Pane& pane, const std::vector<Vec3>& places, ImU32 colour, float width);
void loop(const Pane& pane, std::vector<Vec3> places, ImU32 colour, float width);
/// A veil over a flat shape. Nothing when part of it lies behind the eye.
void fill(const Pane& pane, const std::vector<Vec3>& outline, ImU32 colour);
void dot(ImVec2 at, float radius, ImU32 colour);
/// Centred on the place, on a card.
void chip(ImVec2 middle, const std::string& text, ImU32 colour);
/// The same colour, seen through.
ImU32 faint(ImU32 colour, float share);

}  // namespace hanei::sketch
