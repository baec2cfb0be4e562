#include "view/interaction.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include "view/window.h"

namespace tank_datum::view {

vtkStandardNewMacro(Interaction);

void Interaction::OnLeftButtonDown() {
  const int* at = Interactor->GetEventPosition();
  const int station = window->stationAt(at[0], at[1]);
  if (station < 0) return vtkInteractorStyleTrackballCamera::OnLeftButtonDown();
  window->pick(station);
  Interactor->Render();
}

void Interaction::OnChar() {
  const char key = Interactor->GetKeyCode();
  if (key == 'q') return Interactor->TerminateApp();
  if (window->press(key)) Interactor->Render();
}

}  // namespace tank_datum::view
