package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class FirstProgramTest {

  @Test
  void theReadmeHasItsLines() throws IOException {
    List<String> readme = Files.readAllLines(Path.of("README.md"));

    FirstProgram.python(new InetSocketAddress(InetAddress.getLoopbackAddress(), 8879))
        .lines()
        .forEach(line -> assertThat(readme).anyMatch(text -> text.startsWith(line)));
  }
}
