#pragma once
// How what the sensor should have read changes with each parameter, of the model's terms and of forms that it might
// get.
#include <vector>

#include "core/diagnosis/model/channel_columns.h"
#include "core/diagnosis/model/forward_model.h"

namespace heft::diagnosis {

/// How valueOf() changes with each parameter: size() columns. They follow the model from step to step
/// of a fit: columns that do not depend on what moved, or hardly, are kept. The signals must outlive them.
class CachedJacobian {
 public:
  CachedJacobian(const Signals& signals, const Model& model);
  /// Of a model that may begin with the terms of the one that others are known for.
  CachedJacobian(const CachedJacobian& known, const Model& model);

  /// Good for the next step from `model`, which has the same terms.
  void follow(const Model& model);
  /// As good as new: nothing that differences tell has moved since.
  void refresh(const Model& model);

  const ChannelColumns& columns() const { return columns_; }

 private:
  void fill(const Model& model);
  void update(const Model& model, double far);

  const Signals* signals_;
  ChannelColumns columns_;
  Model whole_, own_;  ///< Where all columns were worked out together, and each term's own ones
};

/// A model that a form may be added to; neither it nor the signals may go before this.
class LinearisationPoint {
 public:
  LinearisationPoint(const Signals& signals, const Model& model);
  /// How the reading changes with each parameter in form.scan at form.start: scan.size() columns.
  ChannelColumns signatures(const Form& form) const;
  /// Whether a term has S stand otherwise than recorded.
  bool turnsAxes() const { return kinematics_.turned != nullptr; }
  /// What the sensor makes of forces, where that is one matrix for all instants.
  Matrix6d sensorMatrix() const;

 private:
  const Signals& signals_;
  const Model& model_;
  std::vector<const Term*> terms_;  ///< In their order
  Kinematics kinematics_;           ///< As the terms bend it
  Wrenches load_;                   ///< What the sensor carries
  Wrenches sensed_;                 ///< Without what adds to the readings
};

}  // namespace heft::diagnosis
