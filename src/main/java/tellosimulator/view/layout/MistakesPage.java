package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import java.util.List;
import java.util.function.Function;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import tellosimulator.view.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** All that is wrong with a scenario file, with line and column. For the JavaFX thread. */
final class MistakesPage extends VBox {

  /** Mistakes that are shown; the log has all. Decided: more than somebody reads at once. */
  private static final int MOST = 200;

  private final Button close = new Button();

  MistakesPage(ViewContext context, List<Function<Language, String>> mistakes) {
    Language language = context.language();
    Messages messages = language.messages(MistakesPage.class);
    setId("mistakes-page");
    setMaxHeight(USE_PREF_SIZE);
    getStyleClass().addAll("page", "mistakes-page");
    getStylesheets().add(MistakesPage.class.getResource("pages.css").toExternalForm());
    Label title = new Label();
    title.textProperty().bind(messages.text("mistakes", mistakes.size()));
    title.getStyleClass().add(Styles.TITLE_3);
    Label stays = new Label();
    stays.textProperty().bind(messages.text("mistakes-stays"));
    stays.getStyleClass().add("muted");
    VBox lines = new VBox();
    lines.getStyleClass().add("lines");
    for (Function<Language, String> mistake :
        mistakes.subList(0, Math.min(MOST, mistakes.size()))) {
      Label line = new Label();
      line.textProperty().bind(language.localeProperty().map(locale -> mistake.apply(language)));
      line.setWrapText(true);
      line.setMinHeight(Region.USE_PREF_SIZE);
      lines.getChildren().add(line);
    }
    ScrollPane scroll = new ScrollPane(lines);
    scroll.setFitToWidth(true);
    scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
    close.setId("mistakes-close");
    close.setDefaultButton(true);
    close.textProperty().bind(messages.text("close"));
    HBox buttons = new HBox(close);
    buttons.getStyleClass().add("page-buttons");
    getChildren().addAll(title, stays, scroll, buttons);
  }

  Button closeButton() {
    return close;
  }
}
