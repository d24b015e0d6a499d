package tellosimulator.wire;

import java.util.List;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;

/**
 * A row of the table: what is sent in which situation to which drone, and what must come of it.
 *
 * @param place file and line
 * @param fact the id of the fact that it shows, see {@link FactIndex}
 * @param profile the drone's
 * @param behavior the drone's
 * @param before steps that lead to the situation
 * @param input what is sent
 * @param replies what must come back, in this order, and nothing else
 * @param afterwards steps and checks when the last reply has come
 * @param source where the fact is known from
 */
record WireRow(
    String place,
    String fact,
    Profile profile,
    Behavior behavior,
    List<String> before,
    String input,
    List<ExpectedReply> replies,
    List<String> afterwards,
    String source) {

  /** For the report of the tests. */
  String title() {
    return "%s: `%s`, %s, %s (%s)"
        .formatted(fact, input, profile.option(), behavior.option(), place);
  }
}
