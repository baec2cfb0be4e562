#pragma once

#include <vtkProp.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include "view/actors.h"

namespace tank_datum::view {

/// The keys, one per line.
extern const char* const kKeys;

/// By which a picture is known again: the value of its PNG text "Software".
constexpr const char* kPictureMark = "tank_datum_view";

/// A window on a result. Needs a display that answers.
class Window {
 public:
  /// @param on_screen  false: drawn into memory, for a screenshot
  Window(const ViewedResult& result, const Points& cloud, const SceneOptions& options, bool on_screen);

  /// Shows it until the user closes it.
  void run();

  /// Makes it light, for paper, without what only a window can do.
  void whiten();

  /// Writes what is seen as a PNG.
  /// @throws Error (File)
  void screenshot(const std::string& path);

  /// Shows a station's values, as a click on it does; -1: none.
  void pick(int station);

  /// Does what a key does; false of a key that means nothing.
  bool press(char key);

  /// The station drawn nearest to a pixel, or -1.
  int stationAt(int x, int y);

 private:
  void drawCloud();
  void drawDatum();
  void drawLabels();
  void toggle(std::vector<vtkSmartPointer<vtkProp>>& props);
  void drawFrame();
  void replace(std::vector<vtkSmartPointer<vtkProp>>& props, std::vector<vtkSmartPointer<vtkProp>> by);
  void look();

  const ViewedResult& result_;
  const Points& cloud_;
  SceneOptions options_;
  int picked_ = -1;
  std::vector<vtkSmartPointer<vtkProp>> points_, key_, edge_, curve_, plane_, labels_, mark_, frame_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderer> above_;  ///< what no point of the cloud hides: the datum and words
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkTextActor> values_, help_, heading_, key_title_;
};

}  // namespace tank_datum::view
