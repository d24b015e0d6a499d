package tellosimulator.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import tellosimulator.wire.FactIndex.Fact;

class FactIndexTest {

  /** Decided: at most this many facts may be missing, with reasons in `docs/protocol.md`. */
  private static final int MOST_MISSING = 5;

  private final List<Fact> facts = FactIndex.facts();
  private final Set<String> shown =
      WireTable.rows().stream().map(WireRow::fact).collect(Collectors.toSet());

  @Test
  void everyFactHasARowOrAReasonWhyNot() {
    assertThat(facts)
        .allSatisfy(
            fact -> {
              assertThat(fact.shown() || fact.elsewhere() || fact.missing()).as(fact.id()).isTrue();
              assertThat(shown.contains(fact.id())).as(fact.id()).isEqualTo(fact.shown());
            });
  }

  @Test
  void everyRowShowsAFactOfTheIndex() {
    assertThat(facts).extracting(Fact::id).doesNotHaveDuplicates().containsAll(shown);
  }

  @Test
  void atMostFiveFactsAreMissing() {
    assertThat(facts.stream().filter(Fact::missing)).hasSizeLessThanOrEqualTo(MOST_MISSING);
  }
}
