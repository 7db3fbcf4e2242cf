#include "engine/plan/settings.h"

namespace hanei {

std::string_view name_of(Method method) {
    switch (method) {
        case Method::paper:
            return "paper";
        case Method::patch:
            return "patch";
    }
    return "";
}

}  // namespace hanei
