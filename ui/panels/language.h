/// The language of the window is that of its pictures.
#pragma once

#include "ui/view/language.h"
