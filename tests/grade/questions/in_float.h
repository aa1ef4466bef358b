// How exactly a student must compute.
#pragma once

#include <algorithm>
#include <limits>

namespace rt::grade
{

/// A lesson's own cases take their tolerance from the subject's scalar type. Students may compute in float.
template <class Subject>
Subject inFloat(Subject subject)
{
    subject.epsilon = std::max(subject.epsilon, double(std::numeric_limits<float>::epsilon()));
    return subject;
}

} // namespace rt::grade
