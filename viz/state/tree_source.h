// Where pictures and ray trees come from: a lesson, another program, or a file.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "common/program/lesson_entry.h"

namespace rt::viz
{

struct TreeSource
{
    std::string title; ///< "06  Fresnel", "exercise06", "tree.json"
    FeatureSet models; ///< what it can show
    /// It asks another process: it may take seconds, or fail.
    bool isSlow = false;
    /// It has one tree, whatever is asked for.
    bool isFixed = false;
    /// Linear RGB; empty: it makes no pictures. Throws std::runtime_error with one sentence.
    std::function<Image(const SceneDescription&, const RenderOptions&)> render;
    /// May be called from another thread; returns early, with anything, once `stop` is set. Throws std::runtime_error
    /// with one sentence.
    std::function<RayTree(const SceneDescription&, const Probe&, const std::atomic<bool>& stop)> inspect;
};

TreeSource lessonSource(const LessonEntry& lesson, Precision precision);

/// The same tree whatever is asked for; no pictures.
TreeSource fileSource(const RayTree& tree, const std::string& file);

/// The source, told another scene than is asked for: another depth cap, another Fresnel formula.
TreeSource with(TreeSource source, const std::string& title, const std::function<void(SceneDescription&)>& change);

/// Everything that may occur in a tree, for sources that do not say.
FeatureSet allFeatures();

} // namespace rt::viz
