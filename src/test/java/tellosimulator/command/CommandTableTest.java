package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.profile.Behavior.REPORT;
import static tellosimulator.profile.Profile.TT;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;

/** Each row of the command table, with accepted texts and their commands, and refused texts. */
class CommandTableTest {

  /** Row; text; method of the target; record. Metres, metres per second, radians to the left. */
  private static final List<Accepted> ACCEPTED = Accepted.read(CommandCases.ACCEPTED);

  /** Row; text; reply. The drone is flying and is not busy. */
  private static final List<Refused> REFUSED = Refused.read(CommandCases.REFUSED);

  record Accepted(CommandSyntax row, String text, String call) {
    static List<Accepted> read(String table) {
      return lines(table)
          .map(cells -> new Accepted(CommandSyntax.valueOf(cells[0]), cells[1], cells[2]))
          .toList();
    }
  }

  record Refused(CommandSyntax row, String text, String reply) {
    static List<Refused> read(String table) {
      return lines(table)
          .map(cells -> new Refused(CommandSyntax.valueOf(cells[0]), cells[1], cells[2]))
          .toList();
    }
  }

  private static Stream<String[]> lines(String table) {
    return table
        .lines()
        .filter(line -> !line.isBlank())
        .map(
            line -> Arrays.stream(line.split("\\|", -1)).map(String::strip).toArray(String[]::new));
  }

  static List<Accepted> accepted() {
    return ACCEPTED;
  }

  static List<Refused> refused() {
    return REFUSED;
  }

  @Test
  void everyRowHasACaseThatIsAcceptedAndOneThatIsRefused() {
    Set<CommandSyntax> all = EnumSet.allOf(CommandSyntax.class);

    assertThat(ACCEPTED).extracting(Accepted::row).containsAll(all);
    assertThat(REFUSED).extracting(Refused::row).containsAll(all);
  }

  @ParameterizedTest
  @MethodSource("accepted")
  void isCarriedOutByOneMethodWithExactValuesAndAnsweredThroughItsResponder(Accepted accepted) {
    HandlerFixture drone = HandlerFixture.flying(TT, REPORT);

    drone.handle(accepted.text());

    assertThat(drone.carriedOut()).containsExactly(accepted.call());
    assertThat(drone.takeReplies()).isEmpty();

    drone.responder().reply(Reply.OK);
    drone.after(0);
    assertThat(drone.takeReplies()).containsExactly("ok");
  }

  @ParameterizedTest
  @MethodSource("refused")
  void isRefusedWithTheExactReply(Refused refused) {
    HandlerFixture drone = HandlerFixture.flying(TT, REPORT);

    drone.handle(refused.text());

    String reply = refused.reply().equals("unknown") ? unknown(refused.text()) : refused.reply();
    assertThat(drone.takeReplies()).containsExactly(reply);
    assertThat(drone.carriedOut()).isEmpty();
  }

  /** Only the upper-case letter makes the command unknown; otherwise the texts are valid. */
  @ParameterizedTest
  @MethodSource("accepted")
  void isUnknownWhenItsFirstLetterChangesCase(Accepted accepted) {
    HandlerFixture drone = HandlerFixture.flying(TT, REPORT);
    char first = accepted.text().charAt(0);
    char other = Character.isUpperCase(first) ? Character.toLowerCase(first) : upper(first);
    String text = other + accepted.text().substring(1);

    drone.handle(text);

    assertThat(drone.takeReplies()).containsExactly(unknown(text));
    assertThat(drone.carriedOut()).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("accepted")
  void isUnknownWithTwoBlanksAnywhere(Accepted accepted) {
    HandlerFixture drone = HandlerFixture.flying(TT, REPORT);
    String text = accepted.text();
    List<String> spoilt =
        Stream.concat(
                Stream.of(" " + text, text + "  "),
                text.chars().filter(c -> c == ' ').mapToObj(c -> text.replace(" ", "  ")))
            .distinct()
            .toList();

    spoilt.forEach(drone::handle);

    assertThat(drone.takeReplies())
        .containsExactlyElementsOf(
            spoilt.stream()
                .map(s -> s.endsWith("  ") ? s.substring(0, s.length() - 1) : s)
                .map(CommandTableTest::unknown)
                .toList());
    assertThat(drone.carriedOut()).isEmpty();
  }

  @ParameterizedTest
  @EnumSource(Profile.class)
  void isKnownToTheProfilesOfItsSdkAndUnknownToOlderOnes(Profile profile) {
    Set<String> known =
        switch (profile) {
          case TELLO -> Set.of("SDK_1_3");
          case EDU -> Set.of("SDK_1_3", "SDK_2_0");
          case TT -> Set.of("SDK_1_3", "SDK_2_0", "SDK_3_0");
        };

    for (Accepted accepted : ACCEPTED) {
      HandlerFixture drone = HandlerFixture.flying(profile, REPORT);
      drone.handle(accepted.text());
      if (known.contains(accepted.row().since().name())) {
        assertThat(drone.carriedOut()).containsExactly(accepted.call());
        assertThat(drone.takeReplies()).isEmpty();
      } else {
        assertThat(drone.carriedOut()).isEmpty();
        assertThat(drone.takeReplies()).containsExactly(unknown(accepted.text()));
      }
    }
  }

  /**
   * Report: while a command runs, all others except these are refused. Measured: reads and `land`
   * are carried out as well.
   */
  @ParameterizedTest
  @EnumSource(Behavior.class)
  void whileAnotherCommandRunsOnlyTheseAreCarriedOut(Behavior behavior) {
    Set<CommandSyntax> expected =
        EnumSet.of(CommandSyntax.RC, CommandSyntax.STOP, CommandSyntax.EMERGENCY);
    if (behavior == Behavior.MEASURED) {
      expected.add(CommandSyntax.COMMAND);
      expected.add(CommandSyntax.LAND);
      Stream.of(CommandSyntax.values())
          .filter(row -> row.verb().endsWith("?") || row.verb().startsWith("EXT "))
          .forEach(expected::add);
    }

    Set<CommandSyntax> carriedOut = EnumSet.noneOf(CommandSyntax.class);
    for (Accepted accepted : ACCEPTED) {
      HandlerFixture drone = HandlerFixture.flying(TT, behavior).busyWith("`up 100`");
      drone.handle(accepted.text());
      if (drone.carriedOut().isEmpty()) {
        assertThat(drone.takeReplies()).containsExactly("error Not joystick");
      } else {
        assertThat(drone.takeReplies()).isEmpty();
        carriedOut.add(accepted.row());
      }
    }

    assertThat(carriedOut).containsExactlyInAnyOrderElementsOf(expected);
  }

  @Test
  void onTheGroundOnlyWhatNeedsTurningMotorsIsRefused() {
    Set<String> flights =
        Set.of(
            "land", "up", "down", "left", "right", "forward", "back", "cw", "ccw", "flip", "go",
            "curve", "jump");

    Set<String> refused =
        ACCEPTED.stream()
            .filter(accepted -> refusedOnTheGround(accepted.text()))
            .map(accepted -> accepted.row().verb())
            .collect(Collectors.toSet());

    assertThat(refused).isEqualTo(flights);
  }

  private static boolean refusedOnTheGround(String text) {
    HandlerFixture drone = HandlerFixture.grounded(TT, REPORT);
    drone.handle(text);
    List<String> replies = drone.takeReplies();
    assertThat(replies.isEmpty() || replies.equals(List.of("error Motor stop"))).isTrue();
    return drone.carriedOut().isEmpty();
  }

  private static String unknown(String text) {
    return "unknown command: " + text;
  }

  private static char upper(char c) {
    return Character.toUpperCase(c);
  }
}
