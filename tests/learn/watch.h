// `learn`: waits for the student to save, and says what came of it.
#pragma once

#include "tests/learn/session.h"

namespace rt::grade
{

/// Until q (0), or an interrupt (130).
int watch(Session& session);

/// Once, for scripts: the exercises of one lesson, or the one whose id is given. 0 if all of them are right, else 1.
int once(Session& session, int lesson, const std::string& id);

} // namespace rt::grade
