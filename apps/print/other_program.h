#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "print/profile.h"

namespace tank_datum {

/// Where PATH has a program, or the one whose path is given; empty where there is none.
std::string findProgram(const std::string& name);

/// Runs a program without its words, its temporary files in the profile's folder, and says whether it ended well within
/// the time; one that does not is ended. A signal that ends this process ends the program and removes the folder.
bool endsWell(std::vector<std::string> words, const Profile& profile, std::chrono::seconds within);

}  // namespace tank_datum
