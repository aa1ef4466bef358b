// The program trade: what an approximation costs and buys.
#pragma once

namespace rt::lesson10
{

/// A promise that could not be kept: `trade --budget` or `--accuracy` found no setting.
inline constexpr int exitPromiseBroken = 4;

/// Runs the command line and returns its exit code: 0 done, 2 bad input or usage, 4 promise not kept, 130 interrupted.
int tradeMain(int argc, char** argv);

} // namespace rt::lesson10
