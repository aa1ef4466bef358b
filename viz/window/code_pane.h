// The lesson's source with the current line lit.
#pragma once

#include "viz/state/algorithm_line.h"
#include "viz/window/pane.h"

namespace rt::viz
{

class CodePane : public Pane
{
public:
    explicit CodePane(Controller& watched);
    bool update(unsigned changes) override;
    bool wheel(int x, int y, bool forward) override;

private:
    Listing listing;
    AlgorithmLines algorithm{listing};
    std::optional<int> scrolledTo; ///< the first row, chosen with the wheel; empty: the lit line decides
    int shownFirst = 0, shownCount = 1, rowCount = 0;

    void paint(Canvas& canvas) override;
    void paintHeading(Canvas& canvas, double height);
    void paintLines(Canvas& canvas, double height);
    void paintRow(Canvas& canvas, const CodeRow& row, double left, double y, bool isLit);
    void paintNote(Canvas& canvas, double y);
    /// The event that the note tells of, or what stands for it while nobody steps.
    Event notedEvent() const;
    double noteWidth(Canvas& canvas) const;
    /// The algorithm's line where it is now, or where the selected ray was followed; 0: unknown.
    int litLine() const;
    /// Another line of the same moment, and what it is: where the selected ray returned, or was sent on its way; 0: unknown.
    std::pair<int, const char*> otherLine() const;
    /// Where the selected ray was followed and returned; 0: unknown, or not yet.
    int followLine() const;
    int returnLine() const;
};

} // namespace rt::viz
