// A setting for a budget: measured, chosen, rendered, checked.
#pragma once

#include <functional>

#include "study.h"

namespace rt::lesson10
{

/// What is asked for: either or both.
struct Wish
{
    std::optional<double> seconds;  ///< CPU time of one thread for the whole picture, at most
    std::optional<double> decibels; ///< PSNR of linear values, at least
    bool many = false; ///< against the picture of many samples; else against the exact one with the same samples
    int manySamples = 256;
};

struct Tried
{
    Setting setting;
    double predictedSeconds = 0, predictedDecibels = 0; ///< the time is predicted from some rows
    double seconds = 0, decibels = 0;                   ///< of the whole picture
    bool kept = false;
};

struct Recommendation
{
    int measured = 0; ///< settings that were measured
    int stride = 1;   ///< every how many rows
    Setting reference;
    std::vector<Tried> tried; ///< the last is the recommendation
    Image image;              ///< of the last
    bool kept() const
    {
        return !tried.empty() && tried.back().kept;
    }
};

/// Measures the candidates on some rows, verifies the accuracy of the best on the whole picture, renders the chosen one on one
/// thread, and chooses again if that took longer than promised, at most 4 times. Empty if it was stopped. `say` gets a line for each thing that is done.
std::optional<Recommendation> recommend(const SceneDescription& scene, const Wish& wish,
                                        const std::function<void(const std::string&)>& say,
                                        const std::atomic<bool>& stop);

} // namespace rt::lesson10
