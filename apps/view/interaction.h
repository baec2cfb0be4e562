#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

namespace tank_datum::view {

class Window;

/// Mouse and keys of the window: a click on the datum curve picks a station, any other drag turns the view.
class Interaction : public vtkInteractorStyleTrackballCamera {
 public:
  static Interaction* New();
  vtkTypeMacro(Interaction, vtkInteractorStyleTrackballCamera);

  void OnLeftButtonDown() override;
  void OnChar() override;

  Window* window = nullptr;
};

}  // namespace tank_datum::view
