package tellosimulator.view.log;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javafx.beans.binding.Bindings;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableBooleanValue;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.SelectionMode;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.stage.FileChooser;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.files.AtomicFile;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The log at the bottom of the window. It lists all events in chronological order; a command and
 * its reply share a row. While the log is folded, only the newest row is visible. Confined to the
 * JavaFX thread.
 */
public final class LogPane extends VBox {

  /** Height of a line as a multiple of the font size. */
  private static final double LINE_HEIGHT = 1.65;

  /**
   * Fraction of the width that the details occupy. Decided: narrow enough that commands and replies
   * stay visible in the list.
   */
  private static final double DETAILS = 0.42;

  private static final KeyCombination COPY =
      new KeyCodeCombination(KeyCode.C, KeyCombination.SHORTCUT_DOWN);

  private final ViewContext context;
  private final LogQueue logQueue;
  private final Language language;
  private final Messages messages;
  private final LogFormat text;
  private final LogModel model;
  private final ListView<LogRow> list = Nodes.named(new ListView<>(), "log-list");
  private final LogToolbar toolbar;
  private final LogDetails details;
  private final FoldedLog newest;
  private final BooleanProperty open = new SimpleBooleanProperty(this, "open", true);
  private final AutoScroll tail = new AutoScroll(list);

  /** Creates a log that shows the lines of {@code logQueue}. */
  public LogPane(ViewContext context, LogQueue logQueue) {
    this.context = context;
    this.logQueue = logQueue;
    this.language = context.language();
    this.messages = language.messages(LogPane.class);
    int drones = context.simulation().drones().size();
    this.text = new LogFormat(language, drones > 1);
    this.model = new LogModel(LogModel.CAPACITY, text::searched);
    this.toolbar =
        new LogToolbar(
            language,
            drones,
            new LogToolbar.Actions(this::clear, this::copy, this::chooseFile, () -> unfold(false)),
            Bindings.size(model.shown()));
    this.details = new LogDetails(text, model, messages);
    this.newest =
        new FoldedLog(
            messages, new LogRowView(text, toolbar.timeStampsProperty()), () -> unfold(true));
    Nodes.named(this, "log", "log-box");
    getStylesheets().add(LogPane.class.getResource("log.css").toExternalForm());
    logQueue.welcome(
        context.simulation().drones().stream().allMatch(drone -> drone.onProperty().get()));
    list.setItems(model.shown());
    list.getSelectionModel().setSelectionMode(SelectionMode.MULTIPLE);
    list.setCellFactory(view -> new LogCell(text, toolbar.timeStampsProperty()));
    list.setPlaceholder(messages.label("nothing"));
    list.accessibleTextProperty().bind(messages.text("title"));
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  /** Whether lines show their simulated time. */
  public BooleanProperty timeStampsProperty() {
    return toolbar.timeStampsProperty();
  }

  /** Whether the whole log is shown, rather than the newest row alone. */
  public BooleanProperty openProperty() {
    return open;
  }

  /** Opens the log and focuses the search field. */
  public void startSearch() {
    open.set(true);
    toolbar.startSearch();
  }

  /** Shows buttons that open the report of the last flight. */
  public void offer(ReportOffer offer) {
    toolbar.offer(offer);
    newest.offer(offer);
  }

  /** Removes all lines, including those in the queue. */
  public void clear() {
    logQueue.drain();
    model.clear();
    details.refresh();
    showNewest();
  }

  /** Puts the lines back into the queue, so that the next log shows them. */
  public void handOver() {
    logQueue.takeBack(model.lines());
  }

  private void layoutParts() {
    HBox body = new HBox(list, details);
    HBox.setHgrow(list, Priority.ALWAYS);
    list.setMinWidth(0);
    details.prefWidthProperty().bind(widthProperty().multiply(DETAILS));
    Nodes.unshrinkable(details);
    setVgrow(body, Priority.ALWAYS);
    getChildren().addAll(newest, toolbar, body);
    open.subscribe(
        now -> {
          Nodes.setShown(newest, !now);
          Nodes.setShown(toolbar, now);
          Nodes.setShown(body, now);
        });
  }

  private void setupEventHandlers() {
    context.ticker().onTick(nanos -> takeIn());
    list.addEventFilter(KeyEvent.KEY_PRESSED, this::press);
    details.addEventFilter(KeyEvent.KEY_PRESSED, this::closeByEscape);
    list.addEventHandler(MouseEvent.MOUSE_CLICKED, this::click);
    list.getSelectionModel()
        .selectedItemProperty()
        .addListener(
            (property, before, now) -> {
              if (now != null && details.isOpen()) {
                details.open(now);
              }
            });
  }

  private void setupBindings() {
    toolbar.levelProperty().subscribe(level -> refilter(() -> model.setLevel(level)));
    toolbar.droneProperty().subscribe(drone -> refilter(() -> model.setDrone(drone)));
    toolbar.searchProperty().subscribe(wanted -> refilter(() -> model.setText(wanted)));
    // Rounded to whole pixels: the list would treat a fraction of a pixel as a gap.
    toolbar
        .fontProperty()
        .subscribe(font -> list.setFixedCellSize(snapSizeY(font.getSize() * LINE_HEIGHT)));
    toolbar.autoscrollProperty().bindBidirectional(tail.followingProperty());
    language
        .localeProperty()
        .subscribe(
            locale -> {
              refilter(model::wordsChanged);
              list.refresh();
              details.refresh();
              showNewest();
            });
  }

  private void takeIn() {
    tail.settle();
    List<LogLine> lines = logQueue.drain();
    if (!lines.isEmpty()) {
      tail.moveOn(model.append(lines));
      details.refresh();
      showNewest();
    }
  }

  private void showNewest() {
    List<LogRow> shown = model.shown();
    newest.show(shown.isEmpty() ? Optional.empty() : Optional.of(shown.get(shown.size() - 1)));
  }

  /**
   * Unfolds the log and focuses its list, or folds the log and focuses the button that unfolds it.
   */
  private void unfold(boolean wanted) {
    open.set(wanted);
    if (wanted) {
      list.requestFocus();
    } else {
      newest.button().requestFocus();
    }
  }

  private void press(KeyEvent event) {
    LogRow selected = list.getSelectionModel().getSelectedItem();
    if (COPY.match(event)) {
      copy();
      event.consume();
    } else if (event.getCode() == KeyCode.ENTER && selected != null) {
      details.toggle(selected);
      event.consume();
    } else {
      closeByEscape(event);
    }
  }

  private void closeByEscape(KeyEvent event) {
    if (event.getCode() == KeyCode.ESCAPE && details.isOpen()) {
      details.close();
      list.requestFocus();
      event.consume();
    }
  }

  /**
   * Opens or closes the details of the clicked row. Ignores clicks with Shift or Ctrl, which select
   * several rows.
   */
  private void click(MouseEvent event) {
    boolean plain = !event.isShiftDown() && !event.isShortcutDown() && event.isStillSincePress();
    for (Node node = event.getPickResult().getIntersectedNode();
        node != null && plain && event.getButton() == MouseButton.PRIMARY;
        node = node.getParent()) {
      if (node instanceof ListCell<?> cell && cell.getItem() instanceof LogRow row) {
        details.toggle(row);
        return;
      }
    }
  }

  private void refilter(Runnable change) {
    list.getSelectionModel().clearSelection();
    change.run();
    tail.moveOn(0);
  }

  /**
   * Copies the lines of the selected rows, or of all rows that pass the filter if none is selected.
   */
  private void copy() {
    List<LogRow> selected = List.copyOf(list.getSelectionModel().getSelectedItems());
    ClipboardContent content = new ClipboardContent();
    content.putString(
        String.join(
            System.lineSeparator(), written(selected.isEmpty() ? model.shown() : selected)));
    Clipboard.getSystemClipboard().setContent(content);
  }

  private void chooseFile() {
    FileChooser chooser = new FileChooser();
    chooser.setTitle(messages.now("save.tooltip"));
    chooser.setInitialFileName(messages.now("save.name"));
    File chosen = chooser.showSaveDialog(getScene().getWindow());
    if (chosen != null) {
      save(chosen.toPath());
    }
  }

  /** Writes the lines of all rows that pass the filter to a file, and logs the outcome. */
  void save(Path file) {
    try {
      List<String> lines = written(model.shown());
      AtomicFile.write(
          file,
          out -> {
            for (String line : lines) {
              out.write((line + System.lineSeparator()).getBytes(StandardCharsets.UTF_8));
            }
          });
      logQueue.note(LogLevel.INFO, "saved", file);
    } catch (IOException e) {
      logQueue.say(
          LogLevel.ERROR,
          language -> language.messages(LogPane.class).now("not-saved", file, language.reason(e)));
    }
  }

  private List<String> written(List<LogRow> rows) {
    return LogRow.lines(rows).stream().map(text::whole).toList();
  }

  /** A cell that shows a row in the list of the log. Confined to the JavaFX thread. */
  private static final class LogCell extends ListCell<LogRow> {

    private final LogFormat text;
    private final LogRowView view;

    LogCell(LogFormat text, ObservableBooleanValue timeStamps) {
      this.text = text;
      this.view = new LogRowView(text, timeStamps);
      setPrefWidth(0); // makes the cell as wide as the list, never wider
      setText(null);
    }

    @Override
    protected void updateItem(LogRow row, boolean empty) {
      super.updateItem(row, empty);
      if (empty || row == null) {
        setGraphic(null);
        setAccessibleText(null);
        return;
      }
      view.show(row);
      setGraphic(view);
      setAccessibleText(text.spoken(row));
    }
  }

  /**
   * The folded log: its newest row, a button for the report of the last flight, and a button that
   * unfolds the log. Confined to the JavaFX thread.
   */
  private static final class FoldedLog extends HBox {

    private final Button button =
        Nodes.named(new Button("", new FontIcon(Feather.CHEVRON_UP)), "log-unfold");
    private final LogRowView row;
    private final ReportButton report;

    /**
     * @param row shows the newest row
     * @param unfold shows the whole log
     */
    FoldedLog(Messages messages, LogRowView row, Runnable unfold) {
      this.row = row;
      report =
          new ReportButton(
              messages, "folded-report", new SimpleObjectProperty<>(ContentDisplay.LEFT));
      Nodes.described(button, messages.text("unfold.tooltip"));
      button.setOnAction(pressed -> unfold.run());
      Nodes.styled(this, "log-toolbar", "log-folded");
      setAlignment(Pos.CENTER_LEFT);
      setHgrow(row, Priority.ALWAYS);
      row.setMinWidth(0);
      getChildren()
          .addAll(messages.label("title", "log-title"), row, report, Nodes.unshrinkable(button));
    }

    /** Shows the button that opens the report of the last flight. */
    void offer(ReportOffer offer) {
      report.offer(offer);
    }

    /** Returns the button that unfolds the log. */
    Button button() {
      return button;
    }

    /** Shows the newest row, if there is one. */
    void show(Optional<LogRow> newest) {
      newest.ifPresent(row::show);
      row.setVisible(newest.isPresent());
    }
  }
}
