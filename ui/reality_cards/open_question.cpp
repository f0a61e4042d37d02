#include "ui/reality_cards/open_question.h"

#include "ui/controller/reality_findings.h"
#include "ui/reality_cards/cause_numbers.h"
#include "ui/reality_cards/cause_words.h"

namespace heft {

OpenQuestion openQuestion(Workspace& workspace) {
  OpenQuestion out;
  const OpenCauses open = openCauses(workspace);
  if (!open.report) return out;
  for (const DiagnosedCause* cause : open.causes) out.causes << sentenceOf(*cause, *open.report);
  out.moved = open.moved;
  // What is already applied is no longer an open question.
  if (workspace.corrections().causes.empty()) out.change = payloadChange(*open.report).text;
  return out;
}

KnownPayload knownPayload(const Workspace& workspace) {
  KnownPayload out;
  if (const auto opened = workspace.opened()) out.payload = opened->recording.meta.knownPayload;
  const PartialPayload& said = workspace.session().settings.known;
  out.byUser = said.mass || said.com || said.inertiaCom;
  if (said.mass) out.payload.mass = said.mass;
  if (said.com) out.payload.com = said.com;
  if (said.inertiaCom) out.payload.inertiaCom = said.inertiaCom;
  return out;
}

}  // namespace heft
