#include "tests/grade/questions/run_criterion.h"

#include "common/base/todo.h"
#include "common/tree/tree_diff.h"
#include "lessons/programs/registry.h"

namespace rt::grade
{

namespace
{

constexpr double enough = 0.95; // of the cases of a criterion

/// Runs one question and notes how it ended.
struct Runner
{
    CriterionRun& run;
    bool strict = false;
    int answered = 0;

    /// Can it not pass any more? Only asked after a death: each costs a process or seconds, wrong answers cost nothing.
    bool isLost() const { return strict || run.cases - (answered - run.passed) < enough * run.cases; }

    void worse(Outcome outcome) { run.outcome = std::max(run.outcome, outcome); }

    void failed(const std::string& key, const std::string& answer, const Example& example)
    {
        worse(Outcome::wrong);
        run.evidence[key] = answer;
        if (!run.example) run.example = example;
    }

    /// `body` returns whether the case passed.
    template <class Body>
    void operator()(const std::string& key, const std::string& what, const Body& body)
    {
        if (run.gaveUp) return;
        ++answered;
        try
        {
            run.passed += body();
        }
        catch (const NotAttempted&)
        {
            run.notAttempted = true;
            worse(Outcome::notAttempted);
        }
        catch (const Died& died)
        {
            run.outOfTime |= died.outcome == Outcome::timedOut || died.outcome == Outcome::notRun;
            run.gaveUp = isLost();
            const auto rest =
                run.gaveUp && answered < run.cases ? "; its points were lost then, the rest was not asked" : "";
            failed(key, name(died.outcome), {what, "an answer", std::string(died.what()) + rest, {}});
            worse(died.outcome);
        }
        catch (const std::exception& error)
        {
            failed(key, "threw", {what, "an answer", error.what(), {}});
        }
    }
};

template <class Case, class Subject>
void runOwn(Runner& runner, const std::vector<Case>& cases, const Subject& subject, const std::atomic<bool>* stop)
{
    for (const auto& which : cases)
    {
        if (stop && *stop) throw Interrupted();
        const auto key = fmt::format("{}_{}", which.group, which.name);
        runner(key, which.name, [&] {
            rt::cases::Check check;
            which.run(check, subject);
            for (std::size_t i = 0; i < check.failures.size(); ++i)
            {
                const auto& failure = check.failures[i];
                runner.failed(fmt::format("{} {}", key, i), failure.what + ": " + failure.got,
                              {failure.what, failure.expected, failure.got, {}});
            }
            return check.failures.empty();
        });
    }
}

void runQuestions(Runner& runner, const AskedCriterion& asked, const Candidate& candidate,
                  const std::atomic<bool>* stop)
{
    for (std::size_t i = 0; i < asked.questions.size(); ++i)
    {
        if (stop && *stop) throw Interrupted();
        const auto& question = asked.questions[i];
        const auto& expected = asked.expected[i];
        const auto key = fmt::format("{} {}", asked.name, i);
        runner(key, question.what, [&] {
            const auto got = question.ask(candidate);
            const auto wrong = firstWrong(question, expected, got);
            if (!wrong) return true;
            std::string numbers;
            for (const double value : got.values) numbers += fmt::format("{:.7g} ", value);
            runner.failed(key, numbers,
                          {question.what, text(question, expected, *wrong), text(question, got, *wrong),
                           degreesBetween(question, expected, got)});
            return false;
        });
    }
}

int casesOf(const AskedCriterion& asked)
{
    return asked.picture ? asked.picture->pixels
                         : int(asked.own.size() + asked.ownGeometry.size() + asked.questions.size());
}

void runPicture(Runner& runner, const AskedCriterion& asked, const Candidate& candidate)
{
    const auto& question = *asked.picture;
    auto& run = runner.run;
    run.cases = 1;
    Image got;
    runner(asked.name, "the picture", [&] {
        got = candidate.tracer.picture(question.scene);
        return false;
    });
    run.cases = casesOf(asked);
    const auto& expected = question.expected;
    const bool sameSize =
        got.width == expected.width && got.height == expected.height && got.pixels.size() == expected.pixels.size();
    int unwritten = 0;
    for (std::size_t i = 0; sameSize && i < got.pixels.size(); ++i)
    {
        unwritten += question.counts[i] && got.pixels[i] == magenta;
        run.passed += question.counts[i] && wrongBy(expected.pixels[i], got.pixels[i]) == 0;
    }
    run.credit = pictureCredit(question, got);
    if (unwritten > question.pixels / 2)
    {
        run.notAttempted = true;
        runner.worse(Outcome::notAttempted);
    }
    if (run.outcome != Outcome::passed || run.credit == 1) return;
    runner.worse(Outcome::wrong);
    if (sameSize)
        run.picture = got;
    else
        run.example = Example{"size of the picture",
                              fmt::format("{}x{}", expected.width, expected.height),
                              fmt::format("{}x{}", got.width, got.height),
                              {}};
}

} // namespace

CriterionRun runCriterion(const AskedCriterion& asked, const Candidate& candidate, const std::atomic<bool>* stop,
                          bool strict)
{
    if (stop && *stop) throw Interrupted();
    CriterionRun run;
    Runner runner{run, strict};
    if (asked.picture)
        runPicture(runner, asked, candidate);
    else
    {
        run.cases = casesOf(asked);
        runOwn(runner, asked.own, inFloat(candidate.tracer), stop);
        runOwn(runner, asked.ownGeometry, inFloat(candidate.geometry), stop);
        runQuestions(runner, asked, candidate, stop);
        run.credit = run.passed >= enough * run.cases ? 1 : 0;
    }
    if (run.notAttempted) run.credit = 0;
    if (candidate.fingerprint) run.fingerprint = candidate.fingerprint();
    return run;
}

CriterionRun notAsked(const AskedCriterion& asked)
{
    CriterionRun run;
    run.cases = casesOf(asked);
    run.outcome = Outcome::notRun;
    run.outOfTime = run.gaveUp = true;
    return run;
}

PictureTriple compareFor(const AskedCriterion& asked, const Image& got, const Candidate& candidate, int lesson)
{
    const auto& [scene, expected, counts, pixels] = *asked.picture;
    PictureTriple triple{asked.name, expected, got, Image(got.width, got.height), 0, 0, "", "", sceneToToml(scene)};
    double worst = -1;
    for (std::size_t i = 0; i < got.pixels.size(); ++i)
    {
        triple.difference.pixels[i] = isFinite(got.pixels[i]) ? V(abs(got.pixels[i] - expected.pixels[i])) : V(1);
        const double wrong = counts[i] ? wrongBy(expected.pixels[i], got.pixels[i]) : -1;
        if (wrong <= worst) continue;
        worst = wrong;
        triple.x = int(i) % got.width;
        triple.y = int(i) / got.width;
    }
    try
    {
        const auto* entry = findLesson(lesson);
        const auto ray = Scene<double>(scene).camera.ray(triple.x + 0.5, triple.y + 0.5);
        const auto ours = entry->inspect(scene, Precision::doubled, GivenRay{ray.O, ray.D});
        if (const auto difference =
                firstDifference(ours, candidate.tracer.tree(scene, ray.O, ray.D), floatAgainstDouble()))
            triple.divergence = describe(*difference);
    }
    catch (const std::exception&)
    {
        // No tree, no divergence; the pictures still help.
    }
    triple.command =
        fmt::format("./raytree view {} SCENE --pixel {},{} --compare exercise", lesson, triple.x, triple.y);
    return triple;
}

} // namespace rt::grade
