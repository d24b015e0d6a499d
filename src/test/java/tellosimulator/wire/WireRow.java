package tellosimulator.wire;

import java.util.List;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;

/**
 * A row of the table: an input in a situation of a drone, and its expected effects.
 *
 * @param place file and line
 * @param fact the id of the fact that it shows, see {@link FactIndex}
 * @param profile the drone's
 * @param behavior the drone's
 * @param before steps that lead to the situation
 * @param input the datagram
 * @param replies all replies that must arrive, in this order
 * @param afterwards steps and checks after the last reply
 * @param source where the fact is documented
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

  /** Returns the title in the test report. */
  String title() {
    return "%s: `%s`, %s, %s (%s)"
        .formatted(fact, input, profile.option(), behavior.option(), place);
  }
}
