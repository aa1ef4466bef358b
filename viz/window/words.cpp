#include "viz/window/words.h"

#include <algorithm>

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include "viz/base/palette.h"

namespace rt::viz
{

const Words::Word& Words::operator()(const std::string& text, Font font, int size)
{
    if (words.size() > 20'000) words.clear(); // a user who looks at everything in a large tree
    const auto [entry, isNew] = words.try_emplace(fmt::format("{}/{}/{}", int(font), size, text));
    auto& word = entry->second;
    if (!isNew) return word;
    vtkNew<vtkTextProperty> property;
    useFont(property, font);
    property->SetFontSize(size);
    property->SetColor(1, 1, 1);
    vtkNew<vtkImageData> image;
    int used[2] = {0, 0};
    if (!vtkTextRenderer::GetInstance()->RenderString(property, vtkStdString(text), image, used, 72)) return word;
    int whole[3];
    image->GetDimensions(whole);
    const auto* pixels = static_cast<const Rgba*>(image->GetScalarPointer());
    int left = whole[0], right = -1, low = whole[1], high = -1;
    for (int y = 0; y < whole[1]; ++y)
        for (int x = 0; x < whole[0]; ++x)
            if (pixels[y * whole[0] + x].a > 0)
            {
                left = std::min(left, x);
                right = std::max(right, x);
                low = std::min(low, y);
                high = std::max(high, y);
            }
    if (right < left) return word;
    word.width = right - left + 1;
    word.height = high - low + 1;
    for (int y = low; y <= high; ++y)
        for (int x = left; x <= right; ++x) word.coverage.push_back(pixels[y * whole[0] + x].a);
    return word;
}

} // namespace rt::viz
