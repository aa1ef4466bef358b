#include "exhibits.h"

#include "subject.h"

namespace rt::lesson10
{

namespace
{

constexpr const char* classic = "lessons/10_speed_and_accuracy/scenes/classic.toml";
constexpr const char* planet = "lessons/10_speed_and_accuracy/scenes/planet.toml";
constexpr const char* farCamera = "lessons/10_speed_and_accuracy/scenes/far_camera.toml";
constexpr const char* moved = "lessons/10_speed_and_accuracy/scenes/moved.toml";
constexpr const char* underwater = "lessons/10_speed_and_accuracy/scenes/underwater.toml";
constexpr const char* tiny = "lessons/10_speed_and_accuracy/scenes/tiny.toml";
constexpr const char* thinShell = "lessons/10_speed_and_accuracy/scenes/thin_shell.toml";

} // namespace

std::span<const Exhibit> exhibits()
{
    static const Exhibit all[] = {
        {"acne",
         planet,
         Fault::acne,
         "t > 0: the point lies beside the ground, and every second shadow ray meets the ground again",
         "the ray carries the primitive that it leaves",
         {.scalar = Scalar::floating, .leaving = LeavingPolicy::anyPositive, .cutoff = 0},
         {.scalar = Scalar::floating, .cutoff = 0}},
        {"tmin_too_small",
         planet,
         Fault::acne,
         "t > 1e-4: the rounding of a planet is larger than that",
         "exclusion has no length that could be too small",
         {.scalar = Scalar::floating, .leaving = LeavingPolicy::fixedTMin, .cutoff = 0},
         {.scalar = Scalar::floating, .cutoff = 0}},
        {"lost_shells",
         thinShell,
         Fault::leaks,
         "t > 1e-4: the inner surface of the bubbles is nearer than that, so they turn into solid glass",
         "exclusion has no length that could be too large",
         {.leaving = LeavingPolicy::fixedTMin, .depth = 12, .cutoff = 0},
         {.depth = 12, .cutoff = 0}},
        {"leaks",
         tiny,
         Fault::leaks,
         "offset 1e-4: a tenth of a ball's radius here, and rays start behind what they should meet",
         "exclusion moves no point",
         {.leaving = LeavingPolicy::normalOffset, .cutoff = 0},
         {.cutoff = 0}},
        {"leap",
         moved,
         Fault::leaks,
         "offset 1e-4 times the coordinates: a fifth of a unit here, and shadows come loose from what casts them",
         "exclusion moves no point",
         {.leaving = LeavingPolicy::relativeOffset, .cutoff = 0},
         {.cutoff = 0}},
        {"naive",
         farCamera,
         Fault::wrongHit,
         "b² - 4ac in float: the difference of two numbers near 1e8 knows the ball only roughly",
         "Haines: the discriminant without that difference, here in float too",
         {.scalar = Scalar::floatOnly, .sphere = SphereFormula::naive, .cutoff = 0},
         {.scalar = Scalar::floatOnly, .cutoff = 0}},
        {"q_form",
         farCamera,
         Fault::wrongHit,
         "the q-form mends the roots; the discriminant is the naive one, and so is the outline",
         "Haines: the discriminant without that difference, here in float too",
         {.scalar = Scalar::floatOnly, .sphere = SphereFormula::qForm, .cutoff = 0},
         {.scalar = Scalar::floatOnly, .cutoff = 0}},
        {"wrong_angle",
         underwater,
         Fault::wrongLook,
         "Schlick with the angle of incidence also from water into air: the window ends with a hard rim",
         "the larger of the two angles: it fades into the reflection",
         {.glass = GlassModel::schlickWrongAngle, .cutoff = 0},
         {.glass = GlassModel::schlick, .cutoff = 0}},
        {"no_fresnel",
         classic,
         Fault::wrongLook,
         "no Fresnel: all light goes through, the ball mirrors nothing, and where it bends the dark distance it has a "
         "dark ring",
         "the Fresnel equations",
         {.glass = GlassModel::none, .cutoff = 0},
         {.cutoff = 0}},
    };
    return all;
}

const char* name(Fault fault)
{
    constexpr const char* names[] = {"pixels with acne", "pixels with leaks", "pixels that see the wrong thing",
                                     "pixels off by more than 0.1"};
    return names[int(fault)];
}

int countFault(const SceneDescription& scene, const Exhibit& exhibit, const Setting& setting)
{
    // The truth has the depth of the exhibit: here only the poor choice counts.
    const Setting truth{.scalar = Scalar::longDouble, .depth = setting.depth, .cutoff = 0};
    const auto poor = prepare(scene, setting), exact = prepare(scene, truth);
    if (exhibit.fault == Fault::wrongLook) return pixelsOff(poor->render({}), exact->render({}), 0.1);
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    const std::atomic<bool> go = false;
    const bool judge = exhibit.fault != Fault::wrongHit;
    const auto rays = raysAgainst(*poor->inspect(1, judge, most, go), *exact->inspect(1, false, most, go));
    return exhibit.fault == Fault::acne ? rays.acnePixels : judge ? rays.leakPixels : rays.wrongFirst;
}

} // namespace rt::lesson10
