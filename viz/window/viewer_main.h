// The viewer's command line.
#pragma once

namespace rt::viz
{

int viewerMain(int argc, char** argv);

} // namespace rt::viz
