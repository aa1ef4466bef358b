"""The ray tree's JSON schema as tables, in Markdown."""
from course import SiteError


def kind(schema, definitions):
    """What a value may be, in words."""
    if "$ref" in schema:
        name = schema["$ref"].split("/")[-1]
        return {"triple": "3 numbers", "real": "number"}.get(name, f"[{name}](#{name})")
    if "const" in schema:
        return f"`{schema['const']}`"
    if "enum" in schema:
        return ", ".join("null" if value is None else f'`"{value}"`' for value in schema["enum"])
    if "oneOf" in schema:
        return " or ".join("null" if one.get("type") == "null" else "object" for one in schema["oneOf"])
    of = schema.get("type", "any")
    words = " or ".join("null" if one == "null" else one for one in (of if isinstance(of, list) else [of]))
    if of == "array":
        items = kind(schema.get("items", {}), definitions).split(",")[0]
        count = schema.get("minItems")
        return f"{count} {items}s" if count and count == schema.get("maxItems") else f"list of {items}"
    if "exclusiveMinimum" in schema:
        words += f", above {schema['exclusiveMinimum']}"
    elif "maximum" in schema and "minimum" in schema:
        words += f", {schema['minimum']} to {schema['maximum']}"
    elif "minimum" in schema:
        words += f", {schema['minimum']} or more"
    return words


def objects_in(schema):
    """The object that a value may be, if it may be one."""
    if schema.get("type") == "object" and "properties" in schema:
        return schema
    return next((found for found in map(objects_in, schema.get("oneOf", [])) if found), None)


def table(title, schema, definitions, level=2):
    """The keys of an object, then those of the objects within."""
    required = set(schema.get("required", []))
    lines = [f"{'#' * level} {title}", "", "| key | value | always | meaning |", "| --- | --- | --- | --- |"]
    for key, value in schema["properties"].items():
        if "description" not in value:
            raise SiteError(f"common/tree/ray_tree.schema.json: '{key}' of '{title}' has no description")
        meaning = value["description"].replace("|", "\\|").replace("*", "\\*")
        lines.append(f"| `{key}` | {kind(value, definitions)} | {'yes' if key in required else ''} | {meaning} |")
    parts = ["\n".join(lines)]
    for key, value in schema["properties"].items():
        inner = objects_in(value)
        if inner:
            parts.append(table(f"{key} of {title.lower()}" if level > 2 or title != "Top level" else key, inner, definitions, 3))
    return "\n\n".join(parts)


def reference(schema):
    definitions = schema["$defs"]
    parts = [f"# {schema['title']}", schema["description"],
             "The schema itself: [ray_tree.schema.json](ray_tree.schema.json). Every lesson writes such a tree with `--tree json`, "
             "and `./raytree view tree.json` shows one, whoever wrote it.",
             table("Top level", schema, definitions)]
    parts += [table(name[0].upper() + name[1:], value, definitions) for name, value in definitions.items() if "properties" in value]
    parts += ["## An example", "What `./raytree lesson 1 --tree json` prints: one ray, and the shadow rays to two lamps.", "@example@"]
    return "\n\n".join(parts)
