// The lesson's source with the current line lit.
#pragma once

#include "viz/state/listing.h"
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
    std::optional<int> scrolledTo; ///< the first line, chosen with the wheel; empty: the lit line decides
    int shownFirst = 1, shownCount = 1;

    void paint(Canvas& canvas) override;
    void paintHeading(Canvas& canvas, double height);
    void paintLines(Canvas& canvas, double height);
    void paintNote(Canvas& canvas, double y, double textEnd, double lineHeight);
    /// The line where it is now, or where the selected ray was followed; 0: unknown.
    int litLine() const;
    /// Where the selected ray returned; 0: unknown, or not yet.
    int returnLine() const;
};

} // namespace rt::viz
