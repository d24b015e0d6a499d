package tellosimulator.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.function.Executable;
import tellosimulator.profile.Behaviour;
import tellosimulator.profile.Profile;

/** Every fact about the text interface, row by row. */
class WireTest {

  private final List<WireRow> rows = WireTable.rows();

  @TestFactory
  Stream<DynamicTest> everyRowHolds() {
    return rows.stream().map(row -> DynamicTest.dynamicTest(row.title(), checked(row)));
  }

  @Test
  void everyProfileAndBehaviourHasRows() {
    for (Profile profile : Profile.values()) {
      for (Behaviour behaviour : Behaviour.values()) {
        assertThat(rows)
            .as("rows of %s, %s", profile.option(), behaviour.option())
            .anyMatch(row -> row.profile() == profile && row.behaviour() == behaviour);
      }
    }
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
