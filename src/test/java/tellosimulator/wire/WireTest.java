package tellosimulator.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.function.Executable;
import tellosimulator.command.CommandSyntax;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;

/** Tests every fact about the text interface, row by row. */
class WireTest {

  private final List<WireRow> rows = WireTable.rows();

  @TestFactory
  Stream<DynamicTest> everyRowHolds() {
    return rows.stream().map(row -> DynamicTest.dynamicTest(row.title(), checked(row)));
  }

  @Test
  void everyProfileAndBehaviorHasRows() {
    for (Profile profile : Profile.values()) {
      for (Behavior behavior : Behavior.values()) {
        assertThat(rows)
            .as("rows of %s, %s", profile.option(), behavior.option())
            .anyMatch(row -> row.profile() == profile && row.behavior() == behavior);
      }
    }
  }

  @Test
  void everyCommandHasARow() {
    for (CommandSyntax syntax : CommandSyntax.values()) {
      assertThat(rows)
          .as("rows of `%s`", syntax.usage())
          .anyMatch(row -> isForm(syntax, row.input()) && row.profile().knows(syntax.since()));
    }
  }

  private static boolean isForm(CommandSyntax syntax, String input) {
    int words = syntax.usage().split(" ", -1).length;
    return (input + " ").startsWith(syntax.verb() + " ") && input.split(" ", -1).length == words;
  }

  private static Executable checked(WireRow row) {
    return () -> {
      try {
        new WireRun(row).carryOut();
      } catch (AssertionError e) {
        Assertions.fail(
            "%s%n  situation: %s%n  source: %s%n  %s"
                .formatted(row.title(), row.before(), row.source(), e.getMessage()),
            e);
      }
    };
  }
}
