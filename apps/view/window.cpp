#include "view/window.h"

#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdio>

#include "report/display.h"
#include "shape/deformation.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/unknown.h"
#include "view/interaction.h"

namespace tank_datum::view {

const char* const kKeys =
    "1 2 3  colour by height, radial deviation, distance to the datum\n"
    "+ -    exaggerate the datum's heights twice as much, half as much\n"
    "c      cloud\n"
    "e      edge points\n"
    "d      datum curve\n"
    "t      tilt plane\n"
    "l      labels\n"
    "r      whole tank in view\n"
    "h      this list\n"
    "q      quit\n"
    "click on the curve: a station's values";

namespace {

constexpr Rgb kEdge = {1.0, 0.75, 0.1}, kCurve = {0.2, 1.0, 0.5}, kPlane = {0.6, 0.8, 1.0}, kPicked = {1.0, 0.2, 1.0};
constexpr double kReach = 12.0;  ///< of a click [pixels]
constexpr double kMostExaggeration = 1e4;

}  // namespace

Window::Window(const ViewedResult& result, const Points& cloud, const SceneOptions& options, bool on_screen)
    : result_(result),
      cloud_(cloud),
      options_(options),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      above_(vtkSmartPointer<vtkRenderer>::New()),
      window_(vtkSmartPointer<vtkRenderWindow>::New()),
      values_(textAt(0.015, 0.03, false)),
      help_(textAt(0.015, 0.90, true)),
      heading_(textAt(0.015, 0.975, true)),
      key_title_(textAt(0.56, 0.135, false)) {
  window_->SetOffScreenRendering(on_screen ? 0 : 1);
  window_->SetSize(1280, 800);
  window_->SetWindowName("tank_datum_view");
  window_->SetNumberOfLayers(2);
  window_->AddRenderer(renderer_);
  above_->SetLayer(1);
  above_->InteractiveOff();
  above_->SetActiveCamera(renderer_->GetActiveCamera());
  window_->AddRenderer(above_);
  renderer_->SetBackground(0.07, 0.08, 0.10);
  shadeDepths(*renderer_);
  help_->SetInput(kKeys);
  help_->VisibilityOff();
  for (const auto& text : {values_, help_, heading_, key_title_}) above_->AddViewProp(text);
  replace(edge_, {pointsActor(result.edge_points, kEdge, 3.0F)});
  drawCloud();
  drawDatum();
  drawFrame();
  look();
}

void Window::replace(std::vector<vtkSmartPointer<vtkProp>>& props, std::vector<vtkSmartPointer<vtkProp>> by) {
  const bool hidden = !props.empty() && props.front()->GetVisibility() == 0;
  const bool over = &props != &points_ && &props != &edge_ && &props != &plane_;
  vtkRenderer& renderer = over ? *above_ : *renderer_;
  for (const auto& prop : props) renderer.RemoveViewProp(prop);
  props = std::move(by);
  for (const auto& prop : props) {
    if (hidden) prop->VisibilityOff();
    renderer.AddViewProp(prop);
  }
}

void Window::toggle(std::vector<vtkSmartPointer<vtkProp>>& props) {
  for (const auto& prop : props) prop->SetVisibility(prop->GetVisibility() == 0 ? 1 : 0);
}

void Window::drawCloud() {
  const Colouring colouring = colouringOf(cloud_, result_, options_.colour, options_.range);
  const auto cloud = cloudActor(cloud_, colouring);
  key_title_->SetInput((colouring.title + ", grey beyond").c_str());
  replace(points_, {cloud});
  replace(key_, {colourKey(cloud->GetMapper()->GetLookupTable())});
}

void Window::drawDatum() {
  const double e = options_.exaggeration;
  replace(curve_, {curveActor(curvePieces(result_, e), kCurve, 3.0F)});
  const Points plane = tiltPlane(result_, e);
  replace(plane_, plane.empty() ? std::vector<vtkSmartPointer<vtkProp>>()
                                : std::vector<vtkSmartPointer<vtkProp>>{planeActor(plane, kPlane)});
  drawLabels();
  pick(picked_);
  char heading[120];
  std::snprintf(heading, sizeof heading, "datum heights x %g, %zu points drawn, h: keys", e, cloud_.size());
  heading_->SetInput(heading);
}

void Window::drawLabels() {
  std::vector<vtkSmartPointer<vtkProp>> labels;
  for (const std::size_t i : numberedStations(result_, options_.label_every)) {
    Eigen::Vector3d at = markOf(result_, i, options_.exaggeration);
    if (!at.allFinite()) continue;
    at.head<2>() += 0.06 * (at.head<2>() - result_.circle.center);
    labels.push_back(labelActor(at, std::to_string(i)));
  }
  for (const auto& [station, name] : namedStations(result_)) {
    Eigen::Vector3d at = markOf(result_, station, options_.exaggeration);
    if (!at.allFinite()) continue;
    at.head<2>() += 0.36 * (at.head<2>() - result_.circle.center);
    at.z() += 0.12 * result_.circle.radius;  // above the stations' numbers
    labels.push_back(labelActor(at, name));
  }
  replace(labels_, labels);
}

/// The axes of the scan's frame and a bar of a round length, beside the tank.
void Window::drawFrame() {
  constexpr Rgb kFrame = {0.9, 0.9, 0.9};
  const Display::Scale scale = Display(result_.display_units).lengths();
  const double r = result_.circle.radius, round = barLength(scale.factor * r), bar = round / scale.factor;
  const double mean = levelOf(result_.stations).mean;
  const Eigen::Vector3d centre(result_.circle.center.x(), result_.circle.center.y(), mean);
  const Eigen::Vector3d corner = centre - Eigen::Vector3d(1.1 * r, 1.25 * r, 0.0);
  std::vector<Points> lines = {{corner, corner + Eigen::Vector3d(bar, 0.0, 0.0)}};
  char length[32];
  std::snprintf(length, sizeof length, "%g %s", round, scale.unit.c_str());
  std::vector<vtkSmartPointer<vtkProp>> words = {
      labelActor(corner + Eigen::Vector3d(0.5 * bar, -0.07 * r, 0.0), length)};
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d along = 0.25 * r * Eigen::Vector3d::Unit(axis);
    lines.push_back({centre, centre + along});
    words.push_back(labelActor(centre + 1.15 * along, names[axis]));
  }
  words.push_back(curveActor(lines, kFrame, 3.0F));
  replace(frame_, words);
}

void Window::pick(int station) {
  picked_ = station;
  std::vector<vtkSmartPointer<vtkProp>> mark;
  values_->SetInput("");
  if (station >= 0) {
    const Eigen::Vector3d at = markOf(result_, static_cast<std::size_t>(station), options_.exaggeration);
    if (at.allFinite()) mark.push_back(pointsActor({at}, kPicked, 14.0F));
    values_->SetInput(describe(result_, static_cast<std::size_t>(station)).c_str());
  }
  replace(mark_, mark);
}

void Window::look() {
  const Eigen::Vector2d c = result_.circle.center;
  const double r = result_.circle.radius;
  const std::array<double, 6> bounds = boundsOf(result_, cloud_);
  const double middle = 0.5 * (bounds[4] + bounds[5]);
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetFocalPoint(c.x(), c.y(), middle);
  camera->SetPosition(c.x() - 1.2 * r, c.y() - 3.2 * r, middle + 2.2 * r);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer_->ResetCamera(bounds.data());
  renderer_->ResetCameraClippingRange();
}

int Window::stationAt(int x, int y) {
  std::vector<Eigen::Vector2d> marks;
  for (std::size_t i = 0; i < result_.stations.size(); ++i) {
    const Eigen::Vector3d at = markOf(result_, i, options_.exaggeration);
    renderer_->SetWorldPoint(at.x(), at.y(), at.z(), 1.0);
    renderer_->WorldToDisplay();
    marks.emplace_back(renderer_->GetDisplayPoint()[0], renderer_->GetDisplayPoint()[1]);
    if (!at.allFinite()) marks.back().setConstant(kUnknown);
  }
  return nearestMark(marks, {x, y}, kReach);
}

bool Window::press(char key) {
  const std::string colours = "123", layers = "cedtl";
  std::vector<vtkSmartPointer<vtkProp>>* const props[] = {&points_, &edge_, &curve_, &plane_, &labels_};
  if (const auto i = colours.find(key); i != std::string::npos) {
    options_.colour = static_cast<Colour>(i);
    options_.range = 0.0;
    drawCloud();
  } else if (const auto k = layers.find(key); k != std::string::npos) {
    toggle(*props[k]);
    if (key == 'c') toggle(key_);
  } else if ((key == '+' && options_.exaggeration < kMostExaggeration) || (key == '-' && options_.exaggeration > 1.0)) {
    options_.exaggeration = key == '+' ? 2.0 * options_.exaggeration : std::max(1.0, 0.5 * options_.exaggeration);
    drawDatum();
  } else if (key == 'h') {
    help_->SetVisibility(help_->GetVisibility() == 0 ? 1 : 0);
  } else if (key == 'r') {
    look();
  } else {
    return false;
  }
  return true;
}

void Window::run() {
  auto interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
  auto style = vtkSmartPointer<Interaction>::New();
  style->window = this;
  style->SetDefaultRenderer(renderer_);
  interactor->SetRenderWindow(window_);
  interactor->SetInteractorStyle(style);
  window_->Render();
  interactor->Start();
}

void Window::whiten() {
  constexpr Rgb kDarkCurve = {0.0, 0.45, 0.2}, kPaper = {1.0, 1.0, 1.0};
  renderer_->SetBackground(kPaper[0], kPaper[1], kPaper[2]);
  for (auto* const props : {&curve_, &frame_}) {
    for (const auto& prop : *props) paint(prop, props == &curve_ ? kDarkCurve : kInk);
  }
  for (vtkRenderer* const renderer : {renderer_.Get(), above_.Get()}) blackenWords(*renderer);
  const std::string heading = heading_->GetInput();
  heading_->SetInput(heading.substr(0, heading.rfind(", ")).c_str());
  key_title_->SetPosition(0.015, 0.89);
}

void Window::screenshot(const std::string& path) {
  window_->Render();
  auto image = vtkSmartPointer<vtkWindowToImageFilter>::New();
  image->SetInput(window_);
  image->ReadFrontBufferOff();
  auto writer = vtkSmartPointer<vtkPNGWriter>::New();
  writer->SetFileName(path.c_str());
  writer->AddText("Software", kPictureMark);
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  if (writer->GetErrorCode() != 0) {
    throw Error(Error::Kind::File, "view", path, "not written", "a file in a folder that can be written to");
  }
}

}  // namespace tank_datum::view
