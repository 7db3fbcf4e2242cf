/// hanei new: a project with a furnished room, from the command line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hanei {

struct NewRequest {
    std::filesystem::path out;
    std::string room;  ///< "6x4x2.8", metres
    std::string plan;  ///< "0,0 6,0 6,4 0,4": in place of the first two
    std::string shape = "box";
    std::string reflectances = "70/50/20";
    std::vector<std::string> furniture;  ///< "desk@1.5,2.0,90", sizes as "desk:width=1.8@1.5,2"
    std::vector<std::string> openings;   ///< "window:2@1.5": on wall 2, its middle 1.5 m along
    bool lists = false;                  ///< say what can be furnished with, and end
};
int new_command(const NewRequest& request);

}  // namespace hanei
