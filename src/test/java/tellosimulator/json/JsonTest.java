package tellosimulator.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JsonTest {

  private static Map<String, Object> flat(String text) {
    return Json.flatObject(text, "{\"id\": 1}");
  }

  @Test
  void textsNumbersAndTruthValuesAreReadAndNullIsLeftOut() {
    Map<String, Object> object =
        flat(
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
    assertThatThrownBy(() -> flat(text))
        .isInstanceOf(IllegalArgumentException.class)
        .message()
        .hasLineCount(1);
  }

  @Test
  void aFlatObjectHasNothingNestedHoweverDeepItIs() {
    assertThatThrownBy(() -> flat("{\"a\": [1]}"))
        .hasMessage("a must be a text, a number, true or false, but is something nested");
    assertThatThrownBy(() -> flat("{\"a\": " + "[".repeat(60_000)))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> flat("{".repeat(60_000))).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void whatIsNoObjectIsToldByAnExample() {
    assertThatThrownBy(() -> flat("[1]")).hasMessage("expected a JSON object such as {\"id\": 1}");
  }

  @Test
  void objectsAndArraysAreReadInTheirOrder() {
    Object value =
        Json.value(
            "{\"b\": [1, {\"c\": \"d\", \"n\": null}, [], null], \"a\": {}, \"t\": [true, -2.5]}");

    Map<String, Object> expected = new LinkedHashMap<>();
    expected.put("b", Arrays.asList(1L, Map.of("c", "d"), List.of(), null));
    expected.put("a", Map.of());
    expected.put("t", List.of(true, -2.5));
    assertThat(value).isEqualTo(expected);
    assertThat(((Map<?, ?>) value).keySet()).map(String::valueOf).containsExactly("b", "a", "t");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "[1",
        "[1]]",
        "[1] [2]",
        "{\"a\": [}",
        "[{\"a\": b}]",
        "[a: 1]",
        "- 1",
        "[\n- 1\n]",
        "[*x]",
        "{\"a\": {b: 1}}"
      })
  void whatIsNoJsonIsRefusedInASentence(String text) {
    assertThatThrownBy(() -> Json.value(text))
        .isInstanceOf(IllegalArgumentException.class)
        .message()
        .hasLineCount(1);
  }

  @Test
  void nestingIsBounded() {
    assertThat(Json.value("[".repeat(32) + "]".repeat(32))).isInstanceOf(List.class);
    assertThatThrownBy(() -> Json.value("{\"a\": " + "[".repeat(32) + "]".repeat(32) + "}"))
        .hasMessage("a is nested deeper than 32 times");
    assertThatThrownBy(() -> Json.value("[".repeat(60_000)))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void eachCharacterThatIsWrittenIsReadAgain() {
    StringBuilder all = new StringBuilder("</script><script>");
    for (char c = 0; c < 0x300; c++) {
      all.append(c);
    }
    all.append("\u2028\ufffe\uffff\ud83d\ude00\ud83d");

    String line = Json.text(Map.of("text", all.toString()));

    assertThat(line).isASCII().hasLineCount(1);
    assertThat(Json.value(line)).isEqualTo(Map.of("text", all.toString()));
  }

  @Test
  void aNameStandsOnce() {
    assertThatThrownBy(() -> flat("{\"a\": 1, \"a\": 2}")).hasMessage("a is given twice");
  }

  @Test
  void aFileForPeopleHasALineForEachMember() {
    Map<String, Object> object = Json.object("list", List.of(1, Map.of("a", 2)), "none", List.of());

    assertThat(Json.lines(object))
        .isEqualTo(
            "{\n  \"list\": [\n    1,\n    {\n      \"a\": 2\n    }\n  ],\n  \"none\": []\n}");
    assertThat(Json.value(Json.lines(object))).isEqualTo(Json.value(Json.text(object)));
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
