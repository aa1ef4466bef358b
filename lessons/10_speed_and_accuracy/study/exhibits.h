// Poor choices, each beside what cures it.
#pragma once

#include <span>
#include <string>

#include "metrics.h"
#include "setting.h"

namespace rt::lesson10
{

/// What can be counted of a fault.
enum class Fault
{
    acne,     ///< pixels with a ray that was stopped by the surface it leaves
    leaks,    ///< pixels with a ray that passed what it should meet
    wrongHit, ///< pixels whose camera ray met something else
    wrongLook ///< pixels with a channel off by more than 0.1
};

struct Exhibit
{
    const char* name;  ///< of --exhibit
    const char* scene; ///< file, relative to the project
    Fault fault;
    const char* poor; ///< what to see on the left
    const char* good; ///< and what cures it
    Setting poorSetting, goodSetting;
};

/// In the order of the lesson's page.
std::span<const Exhibit> exhibits();

/// "pixels with acne": what is counted, in a sentence.
const char* name(Fault fault);

/// How many pixels show the fault, against long double with the good choices.
int countFault(const SceneDescription& scene, const Exhibit& exhibit, const Setting& setting);

/// The program lesson10; returns its exit code.
int exhibitsMain(int argc, char** argv);

} // namespace rt::lesson10
