// What programs share beside their command lines (cli.h).
#pragma once

#include <functional>
#include <string>

#include "common/base/interrupt.h"

namespace rt
{

enum ExitCode
{
    exitDone = 0,
    exitBadInput = 2,
    exitNoDisplay = 3,
    exitNeedsOpenImageIO = 5, ///< and no front door (RAYTREE_DOOR) is there to install it; 4 is `trade`'s
    exitInterrupted = 130
};

/// A progress callback: a bar on standard error if that is a terminal, once the work has lasted half a second.
std::function<void(double)> progressBar(const std::string& title);

/// The project's root folder: where its scenes and lesson texts are.
std::string projectFile(const std::string& relative);

} // namespace rt
