#include "common/scene/scene.h"

namespace rt
{

RAYTREE_SCENE(, float)
RAYTREE_SCENE(, double)
RAYTREE_SCENE(, long double)

} // namespace rt
