#include "view/actors.h"

#include <vtkCellArray.h>
#include <vtkEDLShading.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkTextProperty.h>

#include <cmath>

namespace tank_datum::view {
namespace {

constexpr int kShades = 256;
constexpr int kPrintedWords = 26;  ///< [pixels], of 800: 7 points in a picture of 70 mm

vtkSmartPointer<vtkPoints> pointsOf(const Points& points) {
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) result->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  return result;
}

/// All points as one cell: a cell for each would take more memory than the points.
vtkSmartPointer<vtkPolyData> cloudOf(const Points& points) {
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  vertices->InsertNextCell(static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) vertices->InsertCellPoint(static_cast<vtkIdType>(i));
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(points));
  data->SetVerts(vertices);
  return data;
}

vtkSmartPointer<vtkActor> actorOf(vtkPolyData* data) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkLookupTable> shades(double low, double high) {
  constexpr Rgb kLow = {0.23, 0.42, 0.85}, kMiddle = {0.86, 0.86, 0.82}, kHigh = {0.85, 0.22, 0.16},
                kBeyond = {0.42, 0.42, 0.44};
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kShades);
  for (int i = 0; i < kShades; ++i) {
    const double t = 2.0 * i / (kShades - 1) - 1.0;
    const Rgb& end = t < 0.0 ? kLow : kHigh;
    Rgb c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = kMiddle[k] + std::abs(t) * (end[k] - kMiddle[k]);
    table->SetTableValue(i, c[0], c[1], c[2]);
  }
  table->SetRange(low, high);
  table->SetBelowRangeColor(kBeyond[0], kBeyond[1], kBeyond[2], 1.0);
  table->SetAboveRangeColor(kBeyond[0], kBeyond[1], kBeyond[2], 1.0);
  table->UseBelowRangeColorOn();
  table->UseAboveRangeColorOn();
  table->SetNanColor(0.3, 0.3, 0.3, 1.0);
  return table;
}

/// The words of a prop; none: nullptr.
vtkTextProperty* wordsOf(vtkProp* prop) {
  if (auto* const label = vtkBillboardTextActor3D::SafeDownCast(prop)) return label->GetTextProperty();
  if (auto* const text = vtkTextActor::SafeDownCast(prop)) return text->GetTextProperty();
  if (auto* const key = vtkScalarBarActor::SafeDownCast(prop)) return key->GetLabelTextProperty();
  return nullptr;
}

}  // namespace

void paint(vtkProp* prop, const Rgb& colour) {
  if (auto* const actor = vtkActor::SafeDownCast(prop)) {
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  }
}

void blackenWords(vtkRenderer& renderer) {
  vtkPropCollection* const props = renderer.GetViewProps();
  props->InitTraversal();
  while (vtkProp* const prop = props->GetNextProp()) {
    vtkTextProperty* const words = wordsOf(prop);
    if (words == nullptr) continue;
    words->SetColor(kInk[0], kInk[1], kInk[2]);
    words->SetBackgroundColor(1.0, 1.0, 1.0);
    words->SetBackgroundOpacity(0.6);
    words->SetFontSize(kPrintedWords);
  }
}

vtkSmartPointer<vtkActor> cloudActor(const Points& points, const Colouring& colouring) {
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->SetNumberOfTuples(static_cast<vtkIdType>(colouring.values.size()));
  for (std::size_t i = 0; i < colouring.values.size(); ++i) {
    values->SetValue(static_cast<vtkIdType>(i), colouring.values[i]);
  }
  const auto data = cloudOf(points);
  data->GetPointData()->SetScalars(values);
  auto actor = actorOf(data);
  actor->GetMapper()->SetLookupTable(shades(colouring.low, colouring.high));
  actor->GetMapper()->UseLookupTableScalarRangeOn();
  actor->GetProperty()->SetPointSize(2.0F);
  return actor;
}

vtkSmartPointer<vtkActor> pointsActor(const Points& points, const Rgb& colour, float pixels) {
  auto actor = actorOf(cloudOf(points));
  paint(actor, colour);
  actor->GetProperty()->SetPointSize(pixels);
  return actor;
}

vtkSmartPointer<vtkActor> curveActor(const std::vector<Points>& pieces, const Rgb& colour, float pixels) {
  Points all;
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  for (const Points& piece : pieces) {
    lines->InsertNextCell(static_cast<int>(piece.size()));
    for (const auto& p : piece) {
      lines->InsertCellPoint(static_cast<vtkIdType>(all.size()));
      all.push_back(p);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(all));
  data->SetLines(lines);
  auto actor = actorOf(data);
  paint(actor, colour);
  actor->GetProperty()->SetLineWidth(pixels);
  return actor;
}

vtkSmartPointer<vtkActor> planeActor(const Points& polygon, const Rgb& colour) {
  auto faces = vtkSmartPointer<vtkCellArray>::New();
  faces->InsertNextCell(static_cast<int>(polygon.size()));
  for (std::size_t i = 0; i < polygon.size(); ++i) faces->InsertCellPoint(static_cast<vtkIdType>(i));
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(polygon));
  data->SetPolys(faces);
  auto actor = actorOf(data);
  paint(actor, colour);
  actor->GetProperty()->SetOpacity(0.35);
  return actor;
}

vtkSmartPointer<vtkBillboardTextActor3D> labelActor(const Eigen::Vector3d& at, const std::string& text) {
  auto actor = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  actor->SetPosition(at.x(), at.y(), at.z());
  actor->SetInput(text.c_str());
  actor->GetTextProperty()->SetFontSize(15);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetBackgroundColor(0.0, 0.0, 0.0);
  actor->GetTextProperty()->SetBackgroundOpacity(0.6);
  return actor;
}

vtkSmartPointer<vtkTextActor> textAt(double x, double y, bool hangs) {
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(x, y);
  text->GetTextProperty()->SetFontSize(15);
  text->GetTextProperty()->SetFontFamilyToCourier();
  text->GetTextProperty()->SetBackgroundColor(0.0, 0.0, 0.0);
  text->GetTextProperty()->SetBackgroundOpacity(0.6);
  if (hangs) text->GetTextProperty()->SetVerticalJustificationToTop();
  return text;
}

vtkSmartPointer<vtkScalarBarActor> colourKey(vtkScalarsToColors* colours) {
  auto scale = vtkSmartPointer<vtkScalarBarActor>::New();
  scale->SetLookupTable(colours);
  scale->SetLabelFormat("%-#.3g");
  scale->UnconstrainedFontSizeOn();
  vtkTextProperty* text = scale->GetLabelTextProperty();
  text->SetFontSize(14);
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
  scale->SetOrientationToHorizontal();
  scale->SetPosition(0.56, 0.02);
  scale->SetWidth(0.40);
  scale->SetHeight(0.12);
  return scale;
}

void shadeDepths(vtkRenderer& renderer) {
  auto steps = vtkSmartPointer<vtkRenderStepsPass>::New();
  auto shading = vtkSmartPointer<vtkEDLShading>::New();
  shading->SetDelegatePass(steps);
  renderer.SetPass(shading);
}

}  // namespace tank_datum::view
