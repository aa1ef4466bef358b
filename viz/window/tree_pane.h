// The recursion as a graph: rays as circles, shadow rays as squares, what was not followed as a barred stub.
#pragma once

#include "viz/drawing/tree_layout.h"
#include "viz/window/pane.h"
#include "viz/window/raster.h"
#include "viz/window/words.h"

namespace rt::viz
{

class TreePane : public Pane
{
public:
    explicit TreePane(Controller& watched);
    bool update(unsigned changes) override;
    bool click(int x, int y) override;
    bool drag(int dx, int dy) override;
    void hover(int x, int y) override;
    void leave() override;
    bool wheel(int x, int y, bool forward) override;
    void dress() override;

    /// Shows the whole tree.
    void fit();
    /// Selects the node of this number and brings it to the middle, large enough to read; tells the controller if there is
    /// none. To be drawn again afterwards.
    void search(const std::string& digits);

private:
    TreeLayout layout;
    TreeView view;
    std::vector<int> extra; ///< of each node: rays that only the tree it is compared with sends from there
    int differing = 0, deepest = 0;
    bool depthsAreLevels = true;
    int pointed = -1; ///< item under the pointer
    bool stale = true;
    vtkNew<vtkImageData> drawn, patch;
    Words words;

    void placed() override;
    void paint(Canvas& canvas) override;
    void rebuild();
    void compare();
    void redraw();
    int itemUnder(int x, int y) const;
    void point(int item);
    double radius() const;
    double shadowHalf() const;
    TreeView::Frame frame() const;
    void paintTitle(Canvas& canvas);
    void paintLegend(Canvas& canvas);
    void paintHover(Canvas& canvas);
    void paintTip(Canvas& canvas, const vec2& at);
    std::vector<std::string> tip() const;
};

} // namespace rt::viz
