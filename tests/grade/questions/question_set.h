// All criteria of one lesson: its own cases, the public questions and the hidden ones, with what the lesson answers.
#pragma once

#include <memory>

#include "tests/cases/cases.h"
#include "tests/grade/questions/ask.h"
#include "tests/grade/questions/manifest.h"
#include "tests/grade/questions/question.h"

namespace rt::grade
{

/// A picture of which some pixels count.
struct PictureQuestion
{
    SceneDescription scene;
    Image expected;
    std::vector<bool> counts; ///< by pixel
    int pixels = 0;           ///< how many count
};

/// One of three: cases of the lesson's own, questions, or a picture.
struct AskedCriterion
{
    std::string exercise, name;
    bool hidden = false;
    double most = 0; ///< points
    std::vector<cases::Case> own = {};
    std::vector<cases::GeometryCase> ownGeometry = {};
    std::vector<Question> questions = {};
    std::vector<Answer> expected = {}; ///< of each question
    std::optional<PictureQuestion> picture = {};
};

using QuestionSet = std::vector<AskedCriterion>;

/// Made once for each lesson, secret and choice of pictures; a few sets are kept. Without a secret: the public criteria.
/// Thread-safe. Throws std::runtime_error if the manifest is broken, or a criterion finds no question whose answer is sure.
std::shared_ptr<const QuestionSet> questionSet(int lesson, const Secret& secret, bool pictures);

/// A pixel's difference: 0 if it is right, else how far off its worst channel is; infinite if that is not finite.
double wrongBy(const V& expected, const V& got);

/// The share of a picture's points: all from 99.5 % of its pixels on, none up to 80 %, linear in between; at most 90 % if
/// any value of the picture, counted or not, is not finite. A picture of another size gets nothing.
double pictureCredit(const PictureQuestion& question, const Image& got);

} // namespace rt::grade
