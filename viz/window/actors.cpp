#include "viz/window/actors.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

namespace rt::viz
{

namespace
{

void addToLight(vtkActor* actor, const char* code)
{
    const std::string hook = "//VTK::Light::Impl";
    actor->GetShaderProperty()->AddFragmentShaderReplacement(hook, true, hook + "\n" + code, false);
}

// n: the normal seen from the viewer, z towards him.
constexpr const char* chrome = R"(
    vec3 n = normalize(normalVCVSOutput);
    vec3 r = reflect(vec3(0.0, 0.0, -1.0), n);
    vec3 above = mix(vec3(0.92, 0.95, 0.98), vec3(0.34, 0.42, 0.52), smoothstep(0.0, 0.9, r.y));
    vec3 below = mix(vec3(0.52, 0.54, 0.57), vec3(0.20, 0.22, 0.25), smoothstep(0.0, -0.8, r.y));
    vec3 studio = mix(below, above, smoothstep(-0.06, 0.06, r.y));
    float rim = pow(1.0 - abs(n.z), 3.0);
    fragOutput0.rgb = mix(diffuseColor * studio * 0.95, vec3(0.75, 0.82, 0.9), 0.35 * rim) + 0.5 * specular;
)";

constexpr const char* glass = R"(
    vec3 n = normalize(normalVCVSOutput);
    float rim = pow(1.0 - abs(n.z), 2.2);
    fragOutput0.rgb = mix(vec3(0.45, 0.62, 0.70), vec3(0.80, 0.93, 1.0), rim) * diffuseColor + specular;
    fragOutput0.a = clamp(0.10 + 0.62 * rim + 0.6 * specular.r, 0.0, 0.95);
)";

vtkSmartPointer<vtkImageData> imageData(const std::vector<Rgba>& pixels, int width, int height)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(width, height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
    for (const auto& p : pixels)
        for (const unsigned char channel : {p.r, p.g, p.b, p.a}) *out++ = channel;
    return image;
}

} // namespace

vtkSmartPointer<vtkPolyData> polyData(const Mesh& mesh)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble(); // scenes may lie far from the origin
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("Colors");
    colors->SetNumberOfComponents(4);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
        const auto& [p, n, c] = std::tie(mesh.points[i], mesh.normals[i], mesh.colors[i]);
        points->InsertNextPoint(p.x, p.y, p.z);
        normals->InsertNextTuple3(n.x, n.y, n.z);
        colors->InsertNextTuple4(c.r, c.g, c.b, c.a);
    }
    vtkNew<vtkCellArray> triangles;
    for (const auto& [a, b, c] : mesh.triangles)
    {
        const vtkIdType ids[] = {a, b, c};
        triangles->InsertNextCell(3, ids);
    }
    data->SetPoints(points);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetScalars(colors);
    data->SetPolys(triangles);
    return data;
}

void setMesh(vtkActor* actor, const Mesh& mesh)
{
    static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(polyData(mesh));
    actor->SetVisibility(!mesh.empty());
}

vtkSmartPointer<vtkActor> meshActor(const Mesh& mesh, Finish finish, bool translucent)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetColorModeToDirectScalars();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    setMesh(actor, mesh);
    auto* property = actor->GetProperty();
    property->SetInterpolationToPhong();
    property->SetAmbient(finish == Finish::vivid ? 0.7 : 0.24);
    property->SetDiffuse(finish == Finish::vivid ? 0.45 : 0.85);
    property->SetSpecular(finish == Finish::matte ? 0.12 : finish == Finish::vivid ? 0.1 : 0.7);
    property->SetSpecularPower(finish == Finish::matte ? 20 : 60);
    if (finish == Finish::plain) property->LightingOff();
    if (finish == Finish::chrome) addToLight(actor, chrome);
    if (finish == Finish::glass) addToLight(actor, glass);
    if (translucent || finish == Finish::glass) actor->ForceTranslucentOn();
    return actor;
}

vtkSmartPointer<vtkActor> pictureActor(const vec3& corner, const vec3& right, const vec3& down,
                                       const std::vector<std::array<double, 2>>& outline)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble(); // scenes may lie far from the origin
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("Texture");
    coordinates->SetNumberOfComponents(2);
    vtkNew<vtkCellArray> polygon;
    polygon->InsertNextCell(int(outline.size()));
    for (const auto& [u, v] : outline)
    {
        const vec3 p = corner + u * right + v * down;
        polygon->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
        coordinates->InsertNextTuple2(u, v);
    }
    data->SetPoints(points);
    data->SetPolys(polygon);
    data->GetPointData()->SetTCoords(coordinates);

    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    vtkNew<vtkTexture> texture;
    texture->InterpolateOn();
    texture->MipmapOn();
    texture->SetWrap(vtkTexture::ClampToEdge);
    texture->SetColorModeToDirectScalars();
    actor->SetTexture(texture);
    return actor;
}

void setPicture(vtkActor* actor, const std::vector<Rgba>& pixels, int width, int height)
{
    actor->GetTexture()->SetInputDataObject(imageData(pixels, width, height));
}

} // namespace rt::viz
