// Which function of a subject has which number on the wire.
#pragma once

#include "tests/cases/lesson00_subject.h"
#include "tests/cases/subject.h"
#include "tests/grade/wire/frames.h"

namespace rt::grade
{

/// visit(number, function) for the functions without a scene.
template <class Tracer, class Visit>
void eachFormula(Tracer& tracer, Visit&& visit)
{
    visit(Function::toSphere, tracer.toSphere);
    visit(Function::toPlane, tracer.toPlane);
    visit(Function::reflect, tracer.reflect);
    visit(Function::latLong, tracer.latLong);
    visit(Function::refract, tracer.refract);
    visit(Function::cosSquared2, tracer.cosSquared2);
    visit(Function::fresnel, tracer.fresnel);
    visit(Function::schlick, tracer.schlick);
    visit(Function::phong, tracer.phong);
}

template <class Geometry, class Visit>
void eachGeometry(Geometry& geometry, Visit&& visit)
{
    visit(Function::slopeIntercept, geometry.slopeIntercept);
    visit(Function::yAt, geometry.yAt);
    visit(Function::implicitForm, geometry.implicitForm);
    visit(Function::normals2, geometry.normals2);
    visit(Function::distanceToOrigin, geometry.distanceToOrigin);
    visit(Function::withUnitNormal, geometry.withUnitNormal);
    visit(Function::segmentLength, geometry.segmentLength);
    visit(Function::parametricForm, geometry.parametricForm);
    visit(Function::normals3, geometry.normals3);
    visit(Function::unitNormal, geometry.unitNormal);
}

} // namespace rt::grade
