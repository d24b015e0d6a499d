package tellosimulator.view.replay;

import java.util.List;
import java.util.function.Consumer;
import javafx.beans.binding.Bindings;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.report.ReportEntry;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Messages;

/** A list cell that shows an event, or a command with its reply and an explanation. */
final class EntryCell extends ListCell<ReportEntry> {

  private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");
  private static final PseudoClass EVENT = PseudoClass.getPseudoClass("event");

  /** Width that a cell needs besides its text, for time, padding and scroll bar [em]. */
  private static final double BESIDE_EMS = 7.2;

  /** Minimum height of an entry [em]. Decided: easy to click. */
  private static final double LEAST_EMS = 2;

  private final ListView<ReportEntry> list;
  private final Messages messages;
  private final boolean severalDrones;
  private final Label time = Nodes.styled(new Label(), "entry-time");
  private final Label text = Nodes.styled(new Label(), "entry-text");
  private final Label reply = Nodes.styled(new Label(), "entry-reply");
  private final Label why = Nodes.styled(new Label(), "entry-why");
  private final HBox parts = Nodes.styled(new HBox(time, new VBox(text, reply, why)), "entry");

  /**
   * Creates a cell.
   *
   * @param severalDrones whether entries must name their drone
   * @param chosen receives a clicked entry, even if it is already selected
   */
  EntryCell(
      ListView<ReportEntry> list,
      Messages messages,
      boolean severalDrones,
      Consumer<ReportEntry> chosen) {
    this.list = list;
    this.messages = messages;
    this.severalDrones = severalDrones;
    setPrefWidth(0); // makes the cell as wide as the list, never wider
    setText(null);
    setOnMouseClicked(
        click -> {
          if (!isEmpty()) {
            chosen.accept(getItem());
          }
        });
    time.setMinWidth(USE_PREF_SIZE);
    HBox.setHgrow(parts.getChildren().get(1), Priority.ALWAYS);
    for (Label words : new Label[] {text, reply, why}) {
      words.setWrapText(true);
      Nodes.showIf(words, words.textProperty().isNotEmpty());
      words
          .prefWidthProperty()
          .bind(
              Bindings.createDoubleBinding(
                  this::wordsWidth, list.widthProperty(), time.fontProperty()));
    }
  }

  private double wordsWidth() {
    return list.getWidth() - BESIDE_EMS * time.getFont().getSize();
  }

  /** Measures the wrapped text, because JavaFX would compute the height of a single line. */
  @Override
  protected double computePrefHeight(double width) {
    if (isEmpty()) {
      return super.computePrefHeight(width);
    }
    double height = snappedTopInset() + snappedBottomInset();
    for (Label words : List.of(text, reply, why)) {
      height += words.isManaged() ? snapSizeY(words.prefHeight(wordsWidth())) : 0;
    }
    return Math.max(height, snapSizeY(LEAST_EMS * time.getFont().getSize()));
  }

  @Override
  protected void updateItem(ReportEntry entry, boolean empty) {
    super.updateItem(entry, empty);
    if (empty || entry == null) {
      setGraphic(null);
      return;
    }
    ReportEntry.Words words = entry.words();
    time.setText(messages.now("seconds", entry.time()));
    text.setText(said(entry));
    reply.setText(words.reply().isEmpty() ? "" : replied(words));
    why.setText(words.why());
    pseudoClassStateChanged(WRONG, entry.wrong());
    pseudoClassStateChanged(EVENT, entry.event());
    setGraphic(parts);
  }

  private String said(ReportEntry entry) {
    int count = entry.words().count();
    String often =
        count > 1 ? messages.now("times", entry.words().text(), count) : entry.words().text();
    return severalDrones && entry.drone().isPresent()
        ? messages.now("of-drone", entry.drone().getAsInt(), often)
        : often;
  }

  private String replied(ReportEntry.Words words) {
    return words.lasted().isPresent() && words.lasted().getAsDouble() >= 0.05
        ? messages.now("replied-after", words.reply(), words.lasted().getAsDouble())
        : messages.now("replied", words.reply());
  }
}
