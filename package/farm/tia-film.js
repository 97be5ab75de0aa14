// tia-film.js - a job type for Flamenco 3: a film in parts that are joined when all are drawn. Copy it to the manager's folder
// "scripts". Flamenco draws a part again when its worker fails. docs/films.md of tia

const JOB_TYPE = {
    label: "Film by tia",
    settings: [
        { key: "scene", type: "string", subtype: "file_path", required: true, description: "Scene file, as workers see it" },
        { key: "output", type: "string", subtype: "file_path", required: true, description: "Film to write, such as /shared/film.y4m" },
        { key: "parts", type: "string", subtype: "dir_path", required: true, description: "Directory of the parts, which must exist" },
        { key: "frames", type: "int32", required: true, default: 240, description: "Number of frames" },
        { key: "chunk_size", type: "int32", default: 10, description: "Frames of a part" },
        { key: "size", type: "string", default: "1920x1080", description: "Width x height in pixels" },
    ],
};

function compileJob(job) {
    const settings = job.settings;
    const join = author.Task("join", "misc");

    for (const chunk of frameChunker(`0-${settings.frames - 1}`, settings.chunk_size)) {
        const range = chunk.includes("-") ? chunk : `${chunk}-${chunk}`;
        const part = path.join(settings.parts, `part-${range.split("-")[0]}.tiapart`);
        const draw = author.Task(`draw-${range}`, "misc");
        draw.addCommand(author.Command("exec", {
            exe: "tia",
            args: ["-o", part, "-n", `${settings.frames}`, "-s", settings.size, "--frame-range", range, settings.scene],
        }));
        job.addTask(draw);
        join.addDependency(draw);
    }
    // A shell lists the parts: a thousand names are no argument of a task.
    join.addCommand(author.Command("exec", {
        exe: "sh",
        args: ["-c", 'exec tia-join -o "$1" "$2"/part-*.tiapart', "sh", settings.output, settings.parts],
    }));
    job.addTask(join);
}
