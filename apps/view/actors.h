#pragma once

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <vector>

#include "view/scene.h"

/// The scene's pieces as VTK draws them.
namespace tank_datum::view {

using Rgb = std::array<double, 3>;

/// Points coloured by their numbers, blue at the low end over white to red, grey beyond both; NaN in dark grey.
vtkSmartPointer<vtkActor> cloudActor(const Points& points, const Colouring& colouring);

/// Points of one colour.
vtkSmartPointer<vtkActor> pointsActor(const Points& points, const Rgb& colour, float pixels);

/// Lines through the pieces.
vtkSmartPointer<vtkActor> curveActor(const std::vector<Points>& pieces, const Rgb& colour, float pixels);

/// A translucent polygon.
vtkSmartPointer<vtkActor> planeActor(const Points& polygon, const Rgb& colour);

/// What dark words and lines are drawn in.
constexpr Rgb kInk = {0.1, 0.1, 0.1};

/// Gives points, lines and faces of one colour another; other props stay.
void paint(vtkProp* prop, const Rgb& colour);

/// Words and the key's figures in dark on white, in place of light on black, and as large as paper needs them.
void blackenWords(vtkRenderer& renderer);

/// A text that faces the camera.
vtkSmartPointer<vtkBillboardTextActor3D> labelActor(const Eigen::Vector3d& at, const std::string& text);

/// A text at a place of the window, from 0 to 1 across and up; it hangs from there or stands on it.
vtkSmartPointer<vtkTextActor> textAt(double x, double y, bool hangs);

/// The key of a cloud's colours, at the window's foot.
vtkSmartPointer<vtkScalarBarActor> colourKey(vtkScalarsToColors* colours);

/// Eye-dome lighting: points before others are set off from them, since a cloud has no surfaces to shade.
void shadeDepths(vtkRenderer& renderer);

}  // namespace tank_datum::view
