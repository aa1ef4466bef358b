#include "viz/window/pane.h"

#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkObjectFactory.h>

namespace rt::viz
{

namespace
{

class PaintItem : public vtkContextItem
{
public:
    static PaintItem* New();
    vtkTypeMacro(PaintItem, vtkContextItem);

    bool Paint(vtkContext2D* painter) override
    {
        if (paint) paint(painter);
        return true;
    }

    std::function<void(vtkContext2D*)> paint;
};

vtkStandardNewMacro(PaintItem);

} // namespace

Pane::Pane(Controller& watched) : controller(watched)
{
    vtkNew<PaintItem> item;
    item->paint = [this](vtkContext2D* painter) {
        Canvas canvas(painter, scale);
        paint(canvas);
    };
    overlay->GetScene()->AddItem(item);
    view->AddActor(overlay);
    setBackground(color::panel);
}

void Pane::setBackground(const Rgba& background)
{
    view->SetBackground(background.r / 255.0, background.g / 255.0, background.b / 255.0);
}

void Pane::dress()
{
    setBackground(color::panel);
}

void Pane::paintIn(vtkRenderer* other)
{
    view->RemoveActor(overlay);
    other->AddActor(overlay);
}

void Pane::paintEdges(Canvas& canvas)
{
    const double hair = canvas.hair();
    canvas.fill({0, area.height - hair, double(area.width), hair}, color::line);
    canvas.fill({area.width - hair, 0, hair, double(area.height)}, color::line);
}

void Pane::place(const Rect& rect, int windowWidth, int windowHeight, double contentScale)
{
    area = rect;
    scale = contentScale;
    if (rect.isEmpty()) return;
    for (auto* part : renderers())
        part->SetViewport(double(rect.x) / windowWidth, double(rect.y) / windowHeight,
                          double(rect.x + rect.width) / windowWidth, double(rect.y + rect.height) / windowHeight);
    placed();
}

} // namespace rt::viz
