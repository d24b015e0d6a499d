package tellosimulator.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JsonTest {

  @Test
  void textsNumbersAndTruthValuesAreReadAndNullIsLeftOut() {
    Map<String, Object> object =
        Json.object(
            "{\"a\": \"ü \\\"b\\\" \\u00e4\\n\", \"n\":-12,\"d\": 1.5e2, \"t\": true, \"f\":false,"
                + "\"z\": null}");

    assertThat(object)
        .isEqualTo(Map.of("a", "ü \"b\" ä\n", "n", -12L, "d", 150.0, "t", true, "f", false));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        "truth",
        "[]",
        "[1]",
        "7",
        "\"a\"",
        "{",
        "}",
        "{\"a\"}",
        "{\"a\": }",
        "{a: 1}",
        "{\"a\": b}",
        "{\"a\": 'b'}",
        "{\"a\": 01}",
        "{\"a\": .5}",
        "{\"a\": 1e999}",
        "{\"a\": NaN}",
        "{\"a\": 0x10}",
        "{\"a\": 1} {\"a\": 1}",
        "{\"a\": 1} x",
        "a: 1",
        "--- {\"a\": 1}\n--- 2",
        "{\"a\": &x 1, \"b\": *x}",
        "{\"a\": *x}",
        "\u0000",
        "{\"a\": \"\u0001\"}",
        "\uFFFD{",
        "%YAML 3.0",
        "!!map {",
        "{\"a\": \"\\q\"}"
      })
  void whatIsNoObjectIsRefusedInASentence(String text) {
    assertThatThrownBy(() -> Json.object(text))
        .isInstanceOf(IllegalArgumentException.class)
        .message()
        .hasLineCount(1);
  }

  @Test
  void nestingIsRefusedHoweverDeepItIs() {
    assertThatThrownBy(() -> Json.object("{\"a\": [1]}"))
        .hasMessage("a must be a text, a number, true or false, but is something nested");
    assertThatThrownBy(() -> Json.object("{\"a\": " + "[".repeat(60_000)))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Json.object("{".repeat(60_000)))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void aNameStandsOnce() {
    assertThatThrownBy(() -> Json.object("{\"a\": 1, \"a\": 2}")).hasMessage("a is given twice");
  }

  @Test
  void whatIsWrittenIsOneLineOfAscii() {
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("text", "ä \"b\" \\ \n \u007f");
    object.put("list", List.of(1, 2.5, true, List.of(), Map.of()));
    object.put("nothing", null);

    assertThat(Json.text(object))
        .isEqualTo(
            "{\"text\": \"\\u00e4 \\\"b\\\" \\\\ \\u000a \\u007f\", \"list\": [1, 2.5, true, [],"
                + " {}], \"nothing\": null}");
  }
}
