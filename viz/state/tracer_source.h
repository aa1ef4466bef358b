// Trees and pictures of another program, which runs in a process of its own: a student's exercise, or any tracer that writes
// RayTree JSON.
#pragma once

#include "viz/state/tree_source.h"

namespace rt::viz
{

/// `command` is the program and its first arguments, split like a shell's words. It is called as
///   COMMAND SCENE --size WxH --depth N --fresnel F --pixel x,y --tree json      (or --ray ox,oy,oz,dx,dy,dz)
/// and writes the tree to standard output; and as
///   COMMAND SCENE --size WxH --depth N --fresnel F --out FILE.exr
/// to make a picture; a program that writes no file makes none. It has `seconds` for a tree and ten times as long for a picture; it is stopped when they are over,
/// or when it writes too much. Failures are one sentence.
TreeSource tracerSource(const std::string& command, double seconds = 10);

} // namespace rt::viz
