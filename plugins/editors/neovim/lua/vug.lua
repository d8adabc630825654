-- SPDX-License-Identifier: Apache-2.0
-- Starts the language server `vug lsp` for scenes. Works from Neovim 0.7 on.
local vug = {}

-- The scene and what it includes are looked up from here.
local function root_of(file)
  return vim.fn.fnamemodify(file, ':p:h')
end

local function run(verb, more)
  return function(command)
    local path = vim.uri_to_fname(command.arguments[1])
    local words = { vug.program, verb, path }
    vim.list_extend(words, more(command.arguments[2]))
    vim.cmd('new')
    vim.fn.termopen(words)
  end
end

-- options.program: the program, "vug" by default.
function vug.setup(options)
  vug.program = options and options.program or 'vug'
  vim.lsp.commands['vug.render'] = run('render', function(item) return { '--render', item } end)
  vim.lsp.commands['vug.preview'] = run('preview', function() return {} end)
  vim.lsp.commands['vug.measure'] = run('measure', function() return {} end)
  vim.api.nvim_create_autocmd('FileType', {
    pattern = 'vug',
    callback = function(args)
      local client = vim.lsp.start_client({
        name = 'vug',
        cmd = { vug.program, 'lsp' },
        root_dir = root_of(args.file),
      })
      if client then vim.lsp.buf_attach_client(args.buf, client) end
      vim.bo[args.buf].omnifunc = 'v:lua.vim.lsp.omnifunc'
    end,
  })
end

return vug
