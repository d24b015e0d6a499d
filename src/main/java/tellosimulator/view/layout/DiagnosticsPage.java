package tellosimulator.view.layout;

import java.util.List;
import java.util.function.Function;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** All that is wrong with a scenario file, with line and column. For the JavaFX thread. */
final class DiagnosticsPage extends Page {

  /** Mistakes that are shown; the log has all. Decided: more than somebody reads at once. */
  private static final int MOST = 200;

  DiagnosticsPage(ViewContext context, List<Function<Language, String>> diagnostics) {
    super(
        "mistakes-page",
        "mistakes-page",
        context
            .language()
            .messages(DiagnosticsPage.class)
            .text(diagnostics.size() == 1 ? "mistakes-one" : "mistakes", diagnostics.size()));
    Language language = context.language();
    Messages messages = language.messages(DiagnosticsPage.class);
    setMaxHeight(USE_PREF_SIZE);
    VBox lines = new VBox();
    lines.getStyleClass().add("lines");
    for (Function<Language, String> diagnostic :
        diagnostics.subList(0, Math.min(MOST, diagnostics.size()))) {
      Label line = new Label();
      line.textProperty().bind(language.localeProperty().map(locale -> diagnostic.apply(language)));
      line.setWrapText(true);
      line.setMinHeight(Region.USE_PREF_SIZE);
      lines.getChildren().add(line);
    }
    ScrollPane scroll = new ScrollPane(lines);
    scroll.setFitToWidth(true);
    scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
    addButton("mistakes-close", messages.text("close"));
    layoutPage(messages.label("mistakes-stays", "muted"), scroll);
  }
}
