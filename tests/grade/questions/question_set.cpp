#include "tests/grade/questions/question_set.h"

#include <map>
#include <mutex>

#include "lessons/programs/registry.h"

namespace rt::grade
{

namespace
{

constexpr double publicShare = 0.3;
constexpr int fewestPixels = 150; // 1 in 200 may be wrong: of 50 pixels that would be none

/// Pixels of the picture. In float, through some six curved surfaces, 6e-8 grows to a few 1e-4.
constexpr Tolerance forPictures{5e-4, 1e-3};

Random randomOf(const std::string& key, int lesson, const Secret& secret, const std::string& exercise,
                const std::string& name)
{
    // Lengths keep ("a", "bc") and ("ab", "c") apart.
    return Random(key, fmt::format("raytree questions, version 1|{}|{}:{}|{}:{}|{}:{}", lesson, secret.term.size(),
                                   secret.term, exercise.size(), exercise, name.size(), name));
}

void addQuestions(AskedCriterion& one, const Criterion& which, Random random, int lesson, const Candidate& lessons)
{
    for (int index = 0, tries = 0; index < questionsInACriterion; ++tries)
    {
        if (tries == 100 * questionsInACriterion)
            throw std::runtime_error(
                fmt::format("{}, {}: no questions whose answer does not hang on rounding", one.exercise, one.name));
        const auto question = which.make(random, index);
        if (question.safe && !question.safe(lesson)) continue;
        one.expected.push_back(question.ask(lessons));
        one.questions.push_back(question);
        ++index;
    }
}

/// Pixels that show the feature, are not black, and are not at an edge: nearly the same from slightly aside and in float.
std::vector<bool> sureOnes(const SceneDescription& scene, const Image& picture, const SceneCriterion& which,
                           const LessonEntry& entry)
{
    std::vector<bool> sure(picture.pixels.size());
    std::vector<Image> others{entry.render(scene, Precision::floating, {})};
    for (const V& shift : {V(2e-5, 1e-5, 0), V(-1e-5, -2e-5, 0)})
    {
        auto aside = scene;
        aside.camera.eye += shift;
        aside.camera.target += shift;
        others.push_back(entry.render(aside, Precision::doubled, {}));
    }
    for (std::size_t i = 0; i < sure.size(); ++i)
    {
        const V color = picture.pixels[i];
        sure[i] = largestChannel(color) > 0.02;
        for (const auto& other : others) sure[i] = sure[i] && wrongBy(color, other.pixels[i]) == 0;
        if (!sure[i]) continue;
        const int x = int(i) % picture.width, y = int(i) / picture.width;
        sure[i] = which.shows(entry.inspect(scene, Precision::doubled, std::array{x, y}));
    }
    return sure;
}

PictureQuestion pictureOf(const SceneCriterion& which, Random random, int lesson, const Candidate& lessons)
{
    for (int tries = 0; tries < 100; ++tries)
    {
        PictureQuestion question;
        question.scene = which.make(random);
        question.scene.title = which.name;
        question.scene.camera.width = 64;
        question.scene.camera.height = 48;
        question.expected = lessons.tracer.picture(question.scene);
        question.counts = sureOnes(question.scene, question.expected, which, *findLesson(lesson));
        question.pixels = int(std::count(question.counts.begin(), question.counts.end(), true));
        if (question.pixels >= fewestPixels) return question;
    }
    throw std::runtime_error(
        fmt::format("{}, {}: no scene shows it in {} pixels", which.exercise, which.name, fewestPixels));
}

/// "Cutoff + Tint" is one criterion of two groups.
void addOwnCases(QuestionSet& set, const Exercise& exercise)
{
    for (const auto& groups : exercise.cases)
    {
        const auto belongs = [&](const char* group) {
            return (" + " + groups + " + ").find(fmt::format(" + {} + ", group)) != std::string::npos;
        };
        AskedCriterion one{.exercise = exercise.id, .name = "cases of the lesson: " + groups};
        for (const auto& which : cases::ownCases(exercise.lesson))
            if (belongs(which.group)) one.own.push_back(which);
        if (exercise.lesson == 0)
            for (const auto& which : cases::geometryCases())
                if (belongs(which.group)) one.ownGeometry.push_back(which);
        if (one.own.empty() && one.ownGeometry.empty())
            throw std::runtime_error(
                fmt::format("lessons/exercises.toml: {}: there are no cases of group {}", exercise.id, groups));
        set.push_back(one);
    }
}

QuestionSet makeSet(int lesson, const Secret& secret, bool pictures)
{
    QuestionSet set;
    const auto lessons = reference(lesson);
    for (const auto& exercise : exercisesOf(lesson))
    {
        const auto first = set.size();
        addOwnCases(set, exercise);
        for (const bool hidden : {false, true})
        {
            if (hidden && secret.course.empty()) continue;
            const std::string key = hidden ? secret.course : "public";
            const Secret terms = hidden ? secret : Secret{};
            for (const auto& which : questionCriteria(lesson))
                if (which.exercise == exercise.id)
                {
                    set.push_back({.exercise = exercise.id, .name = which.name, .hidden = hidden});
                    addQuestions(set.back(), which, randomOf(key, lesson, terms, exercise.id, which.name), lesson,
                                 lessons);
                }
            if (!pictures) continue;
            for (const auto& which : sceneCriteria(lesson))
                if (which.exercise == exercise.id)
                {
                    set.push_back({.exercise = exercise.id, .name = which.name, .hidden = hidden});
                    set.back().picture =
                        pictureOf(which, randomOf(key, lesson, terms, exercise.id, which.name), lesson, lessons);
                }
        }
        const auto count = [&](bool hidden) {
            return double(
                std::count_if(set.begin() + long(first), set.end(), [&](const auto& c) { return c.hidden == hidden; }));
        };
        const double shown = secret.course.empty() ? 1 : publicShare;
        for (auto one = set.begin() + long(first); one != set.end(); ++one)
            one->most = exercise.points * (one->hidden ? (1 - shown) / count(true) : shown / count(false));
    }
    return set;
}

} // namespace

double wrongBy(const V& expected, const V& got)
{
    double worst = 0;
    for (const int c : {0, 1, 2})
    {
        if (!std::isfinite(got[c])) return infinity<double>;
        const double off = std::abs(got[c] - expected[c]);
        if (!(off <= forPictures.absolute + forPictures.relative * std::abs(expected[c]))) worst = std::max(worst, off);
    }
    return worst;
}

double pictureCredit(const PictureQuestion& question, const Image& got)
{
    const auto& expected = question.expected;
    if (got.width != expected.width || got.height != expected.height || got.pixels.size() != expected.pixels.size())
        return 0;
    int right = 0;
    bool finite = true;
    for (std::size_t i = 0; i < got.pixels.size(); ++i)
    {
        finite = finite && isFinite(got.pixels[i]);
        right += question.counts[i] && wrongBy(expected.pixels[i], got.pixels[i]) == 0;
    }
    const double credit = std::clamp((double(right) / question.pixels - 0.8) / (0.995 - 0.8), 0.0, 1.0);
    return finite ? credit : std::min(credit, 0.9);
}

std::shared_ptr<const QuestionSet> questionSet(int lesson, const Secret& secret, bool pictures)
{
    // A criterion of students is asked the same questions; what the lesson answers is computed once.
    static std::mutex mutex;
    static std::map<std::string, std::shared_ptr<const QuestionSet>> kept;
    const std::lock_guard lock(mutex);
    const auto key = fmt::format("{}|{}|{}|{}|{}", lesson, pictures, secret.course.size(), secret.course, secret.term);
    auto& set = kept[key];
    if (!set)
    {
        const auto made = std::make_shared<const QuestionSet>(makeSet(lesson, secret, pictures));
        if (kept.size() > 40) kept.clear();
        return kept[key] = made;
    }
    return set;
}

} // namespace rt::grade
