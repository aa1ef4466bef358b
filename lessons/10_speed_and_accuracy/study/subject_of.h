// Subject for each scalar type: this is included by one source file a type, as they take long to compile.
#pragma once

#include "inspector.h"
#include "lessons/10_speed_and_accuracy/trace.h"
#include "lessons/10_speed_and_accuracy/world.h"
#include "subject.h"

namespace rt::lesson10
{

template <class World>
class SubjectOf : public Subject
{
    using Real = typename World::Real;
    using Fast = Tracer<Real, World>;

    /// rt::render makes its tracers from a Scene: this one knows that it is a World.
    struct FromScene
    {
        Fast tracer;
        explicit FromScene(const Scene<Real>& scene) : tracer{static_cast<const World&>(scene)} {}
        Vec3<Real> trace(const Ray<Real>& ray)
        {
            return tracer.trace(ray);
        }
    };

    SceneDescription description;
    World world;
    int spp, width, height;

public:
    SubjectOf(const SceneDescription& scene, const Setting& setting)
        : description(withSetting(scene, setting)), world(description, setting.glass == GlassModel::schlickWrongAngle),
          spp(setting.spp), width(scene.camera.width), height(scene.camera.height)
    {
    }

    Image render(const RenderOptions& options) const override
    {
        RenderOptions own = options;
        own.spp = spp;
        return rt::render<FromScene>(static_cast<const Scene<Real>&>(world), width, height, own);
    }

    Pass timedPass(int stride, const std::atomic<bool>& stop) const override
    {
        Pass pass{Image(width, (height + stride - 1) / stride)};
        const double start = threadSeconds();
        const TraceLimit limit(&stop);
        Fast tracer{world};
        eachPixel(stride, stop, [&](int x, int row) {
            pass.image.at(x, row) = Vec3<double>(renderPixel<Fast, Real>(world, tracer, x, row * stride, spp));
        });
        pass.cpuSeconds = threadSeconds() - start;
        return pass;
    }

    std::optional<std::vector<PixelFacts>> inspect(int stride, bool judge, std::int64_t mostRays,
                                                   const std::atomic<bool>& stop) const override
    {
        struct TooMany
        {
        };
        /// Counts down before each ray, so that an endless tree ends.
        struct Counted : Inspector<World>
        {
            std::int64_t* left;
            void ray(const Ray<Real>& ray, const std::optional<Hit<Real>>& hit)
            {
                if (--*left < 0) throw TooMany();
                Inspector<World>::ray(ray, hit);
            }
        };
        std::optional<Scene<long double>> exact;
        if (judge) exact.emplace(description);
        std::vector<PixelFacts> all;
        std::vector<typename Inspector<World>::Place> path;
        const TraceLimit limit(&stop);
        try
        {
            eachPixel(stride, stop, [&](int x, int row) {
                PixelFacts facts, others;
                Counted inspector;
                inspector.world = &world;
                inspector.path = &path;
                inspector.left = &mostRays;
                for (int i = 0; i < spp; ++i)
                {
                    inspector.facts = i == 0 ? &facts : &others;
                    inspector.judge = i == 0 && exact ? &*exact : nullptr;
                    Tracer<Real, World, Counted> tracer{world, inspector};
                    const auto [u, v] = samplePosition<Real>(i);
                    beginCameraRay();
                    tracer.trace(world.camera.ray(Real(x) + u, Real(row * stride) + v));
                }
                facts.rays += others.rays;
                all.push_back(facts);
            });
        }
        catch (const TooMany&)
        {
            return std::nullopt;
        }
        return all;
    }

private:
    /// Calls visit(x, y / stride) for every `stride`th row, until `stop` is set. Throws TooManyRays, with the pixel.
    template <class Visit>
    void eachPixel(int stride, const std::atomic<bool>& stop, const Visit& visit) const
    {
        int x = 0, y = 0;
        try
        {
            for (y = 0; y < height && !stop; y += stride)
                for (x = 0; x < width; ++x) visit(x, y / stride);
        }
        catch (const Stopped&)
        {
        }
        catch (const TooManyRays&)
        {
            throw TooManyRays(pixelText(x, y), description.trace.maxDepth);
        }
    }
};

/// Each leaving policy with the good formula, and each poor formula with exclusion.
template <std::floating_point Real, class Good>
std::unique_ptr<Subject> subjectOf(const SceneDescription& scene, const Setting& setting)
{
    const auto make = [&]<class Formula, class Leaving>(Formula, Leaving) -> std::unique_ptr<Subject> {
        return std::make_unique<SubjectOf<World<Real, Formula, Leaving>>>(scene, setting);
    };
    const bool excluding = setting.leaving == LeavingPolicy::exclusion;
    if (setting.sphere == SphereFormula::naive && excluding) return make(Naive(), Exclusion());
    if (setting.sphere == SphereFormula::qForm && excluding) return make(QForm(), Exclusion());
    if (setting.sphere != SphereFormula::haines)
        throw std::invalid_argument("poor sphere formulas are studied with exclusion only");
    switch (setting.leaving)
    {
    case LeavingPolicy::anyPositive:
        return make(Good(), AnyPositive());
    case LeavingPolicy::fixedTMin:
        return make(Good(), FixedTMin());
    case LeavingPolicy::normalOffset:
        return make(Good(), NormalOffset());
    case LeavingPolicy::relativeOffset:
        return make(Good(), RelativeOffset());
    case LeavingPolicy::exclusion:
        break;
    }
    return make(Good(), Exclusion());
}

std::unique_ptr<Subject> floatOnlySubject(const SceneDescription& scene, const Setting& setting);
std::unique_ptr<Subject> floatSubject(const SceneDescription& scene, const Setting& setting);
std::unique_ptr<Subject> doubleSubject(const SceneDescription& scene, const Setting& setting);
std::unique_ptr<Subject> longDoubleSubject(const SceneDescription& scene, const Setting& setting);

} // namespace rt::lesson10
