#pragma once
// What each form of each cause would add to the readings, linearly, kept for a whole search.
#include <functional>
#include <memory>
#include <string_view>

#include "core/diagnosis/model/channel_columns.h"
#include "core/diagnosis/model/linearisation.h"
#include "core/diagnosis/model/noise.h"

namespace heft::diagnosis {

/// A form's columns, ready to be tried on any residual.
struct Signature {
  Form form;
  std::shared_ptr<const ChannelColumns> columns;  ///< form.scan.size(); null: not worked out
  Stretch reach;  ///< The blocks that they are of: outside, whitened or not, they are zero

  /// `part`: of the blocks from `first` on, all that is not zero among them, of a recording of so many `blocks`.
  void fill(const ChannelColumns& part, Eigen::Index first, Eigen::Index blocks);
};

/// The form's signature with its place in time at `time` [s], or as near as it may lie.
Signature signatureAt(double time, Form form, const LinearisationPoint& surroundings);

/// The signatures of one recording, of every form of every cause but those hidden. What a cause adds is the same around
/// every payload and is kept, also around terms that bend the motion or change the sensor as long as these hardly move;
/// what does that itself is worked out anew each time.
class SignatureBank {
 public:
  SignatureBank() = default;
  SignatureBank(const Signals& signals, const std::vector<std::string>& hidden);

  /// Those of `wanted` forms around `model`, on two threads; `signals` are those of the construction but for what may
  /// be judged.
  std::vector<Signature> around(const Signals& signals, const Model& model,
                                const std::function<bool(const Form&)>& wanted = {});

  /// Gives the columns' memory back: what is asked for again is worked out again.
  void forget();

  /// Whether the cause is looked for at all, also by forms that others grow into.
  bool knows(std::string_view cause) const;

 private:
  /// What causes add, around terms that change what comes of it.
  struct Changed {
    std::vector<Term> by;
    std::vector<Signature> signatures;  ///< Each as in plain_
  };

  /// The one around what of `model` changes what causes add, or around nearly the same.
  Changed& changedBy(const Model& model);

  std::vector<Signature> plain_;  ///< Around nothing but a payload; columns once they were needed
  std::vector<Changed> changed_;  ///< The last ones
};

}  // namespace heft::diagnosis
