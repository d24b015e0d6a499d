package tellosimulator.launcher;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.concurrent.Agent.Outcome;

class BoundedCopyTest {

  private static final int LIMIT = BoundedCopy.LIMIT;

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 8192, LIMIT - 1, LIMIT, LIMIT + 1, 2 * LIMIT})
  void noMoreThanTheLimitIsCopiedAndAllIsRead(int printed) throws IOException {
    ByteArrayInputStream from = new ByteArrayInputStream(new byte[printed]);
    ByteArrayOutputStream to = new ByteArrayOutputStream();
    BoundedCopy copy = new BoundedCopy(from, to, BoundedCopy.LIMIT);

    Outcome outcome = Outcome.WORKED;
    while (outcome == Outcome.WORKED) {
      outcome = copy.doWork();
    }

    assertThat(from.available()).isZero();
    String note = "\n[The program printed more than 10 MB; the rest is left out.]\n";
    assertThat(to.size()).isEqualTo(printed <= LIMIT ? printed : LIMIT + note.length());
  }
}
